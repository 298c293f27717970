package rasterlab.grader.rules

import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.application.ApplicationCallPipeline
import io.ktor.server.application.call
import io.ktor.util.AttributeKey
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.AddressedCourse
import rasterlab.grader.course.Identity
import rasterlab.grader.course.addressParts
import rasterlab.grader.course.callers
import rasterlab.grader.course.viewedStudent
import rasterlab.grader.storage.Database
import java.time.ZoneId
import java.time.ZoneOffset
import kotlin.jvm.optionals.getOrNull

/** Knows in which zone the people of a course read times. */
internal class CourseZones(
    private val accounts: Accounts,
    private val database: Database,
) {
    private val addressed = AddressedCourse(database)

    /** The zone that most of the course's deadlines and exams have; UTC where it has none. */
    fun of(course: String): ZoneId =
        database
            .read { handle ->
                handle
                    .createQuery("$ZONES AND course_id = :course")
                    .bind("course", course)
                    .mapTo(String::class.java)
                    .findOne()
            }.map(ZoneId::of)
            .getOrNull() ?: ZoneOffset.UTC

    /** The one zone of all courses that have any; UTC where they have several. */
    private fun common(): ZoneId =
        database
            .read { it.createQuery(ZONES).mapTo(String::class.java).set() }
            .singleOrNull()
            ?.let(ZoneId::of) ?: ZoneOffset.UTC

    /** The zone of the student who calls, and for staff that of the course which the address names. */
    fun of(call: ApplicationCall): ZoneId =
        when (val who = accounts.callers(call).firstOrNull()) {
            null -> ZoneOffset.UTC
            is Identity.StudentIdentity -> of(who.course)
            is Identity.StaffIdentity -> ofStaff(call, who)
        }

    private fun ofStaff(
        call: ApplicationCall,
        who: Identity.StaffIdentity,
    ): ZoneId {
        val course =
            addressed.of(call.addressParts())?.course ?: call.viewedStudent(accounts, who)?.course ?: who.onlyCourse
        return if (course == null) common() else of(course)
    }

    private companion object {
        const val TOLD =
            """SELECT course_id, zone FROM course_exercises WHERE due_at IS NOT NULL OR opens_at IS NOT NULL
               UNION ALL SELECT course_id, zone FROM exams"""

        /** The zone of each course, which most of its deadlines and exams have. */
        const val ZONES =
            """SELECT zone FROM
                   (SELECT course_id, zone,
                        row_number() OVER (PARTITION BY course_id ORDER BY count(*) DESC, zone) AS place
                    FROM ($TOLD) AS told GROUP BY course_id, zone) AS ranked
               WHERE place = 1"""
    }
}

/** The zone in which who calls reads times, looked up when it is asked for. */
internal val READERS_ZONE = AttributeKey<Lazy<ZoneId>>("the zone of its reader's times")

/** Has pages know in which zone their reader reads times. */
fun Application.tellZones(
    accounts: Accounts,
    database: Database,
) {
    val zones = CourseZones(accounts, database)
    intercept(ApplicationCallPipeline.Plugins) { call.attributes.put(READERS_ZONE, lazy { zones.of(call) }) }
}
