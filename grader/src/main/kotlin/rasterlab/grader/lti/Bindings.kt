package rasterlab.grader.lti

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Name
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffRole
import rasterlab.grader.course.StudentRows
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/** A platform's course that is one of the courses here. */
data class BoundContext(
    val platform: String,
    val platformName: String,
    val context: String,
    val title: String,
)

/** Remembers what a platform's courses, people and links are here. */
class Bindings(
    private val database: Database,
    private val clock: InstantSource,
) {
    private val staff = Staff(database, clock)

    /** The course here that the launch leads to; null as long as nobody has said it. */
    fun courseOf(launch: Launch): Course? = database.read { courseOf(it, launch) }

    /** The platforms' courses that a course here is. */
    fun contexts(course: String): List<BoundContext> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT platform_id, name, context, title FROM lti_contexts
                       JOIN lti_platforms ON lti_platforms.id = platform_id
                       WHERE course_id = :course ORDER BY bound_at, platform_id, context""",
                ).bind("course", course)
                .map { row, _ ->
                    BoundContext(
                        row.getString("platform_id"),
                        row.getString("name"),
                        row.getString("context"),
                        row.getString("title"),
                    )
                }.list()
        }

    /**
     * Lets the platform's course be this one, if it is none yet.
     *
     * @param by who does it, for the audit
     */
    fun bind(
        launch: Launch,
        course: Course,
        by: String,
    ) = database.write { handle ->
        val bound =
            handle
                .createUpdate(
                    """INSERT INTO lti_contexts (platform_id, context, title, course_id, bound_at)
                       VALUES (:platform, :context, :title, :course, :now)
                       ON CONFLICT (platform_id, context) DO NOTHING""",
                ).bind("platform", launch.platform)
                .bind("context", launch.context)
                .bind("title", launch.title)
                .bind("course", course.id)
                .bind("now", clock.instant().text())
                .execute()
        if (bound == 1) {
            AuditNote(by, course.id, "lti-bind", course.id, launch.title).write(handle, clock.instant())
        }
    }

    /**
     * Ends that: the next instructor who comes from there is asked again; what was to be sent there is forgotten.
     *
     * @param by who does it, for the audit
     * @throws Rejection.UnknownPlatform where the course is none of that platform's
     */
    fun unbind(
        course: String,
        platform: String,
        context: String,
        by: String,
    ) = database.write { handle ->
        val gone =
            handle
                .createUpdate(
                    """DELETE FROM lti_contexts
                       WHERE platform_id = :platform AND context = :context AND course_id = :course""",
                ).bind("platform", platform)
                .bind("context", context)
                .bind("course", course)
                .execute()
        if (gone == 0) throw Rejection.UnknownPlatform(platform)
        val links = "SELECT id FROM lti_links WHERE platform_id = :platform AND context = :context"
        for (statement in listOf(
            "DELETE FROM lti_scores WHERE link_id IN ($links)",
            "DELETE FROM lti_links WHERE platform_id = :platform AND context = :context",
        )) {
            handle
                .createUpdate(statement)
                .bind("platform", platform)
                .bind("context", context)
                .execute()
        }
        AuditNote(by, course, "lti-unbind", course, context).write(handle, clock.instant())
    }

    /**
     * The id of the student whom the platform means; one who is new in the course is enrolled. A student of the roster is
     * known by the number that both have of the institution, unless somebody else of the platform came as that one. Where
     * the platform calls a student otherwise than the last time, they have that name here too.
     */
    fun student(
        launch: Launch,
        course: Course,
    ): String =
        database
            .read { known(it, launch, course) }
            ?.takeIf { launch.name.isEmpty() || it.toldName == launch.name }
            ?.student
            ?: database.write { handle ->
                known(handle, launch, course)?.also { follow(handle, launch, course, it) }?.student
                    ?: enrolled(handle, launch, course).also { remember(handle, launch, course, it) }
            }

    private fun remember(
        handle: Handle,
        launch: Launch,
        course: Course,
        student: String,
    ) = handle
        .createUpdate(
            """INSERT INTO lti_students (platform_id, subject, course_id, student_id, told_name)
               VALUES (:platform, :subject, :course, :student, :name)
               ON CONFLICT (platform_id, subject, course_id) DO UPDATE SET told_name = excluded.told_name""",
        ).bind("platform", launch.platform)
        .bind("subject", launch.subject)
        .bind("course", course.id)
        .bind("student", student)
        .bind("name", launch.name)
        .execute()

    /** A name that the roster or an instructor gave stays until the platform's changes. */
    private fun follow(
        handle: Handle,
        launch: Launch,
        course: Course,
        known: KnownStudent,
    ) {
        if (launch.name.isEmpty() || known.toldName == launch.name) return
        remember(handle, launch, course, known.student)
        val name = nameIn(launch.name)
        if (known.toldName == null || name == null || name.text == known.name) return
        StudentRows(handle, course.id, clock.instant()).run {
            rename(known.student, known.number, name)
            write()
        }
        AuditNote(launch.platform, course.id, "lti-name", known.student, detail = "").write(handle, clock.instant())
    }

    /** The id of the staff's account that the person has here; null where they have not said which. */
    fun staffOf(launch: Launch): String? =
        database.read { handle ->
            handle
                .createQuery("SELECT account_id FROM lti_staff WHERE platform_id = :platform AND subject = :subject")
                .bind("platform", launch.platform)
                .bind("subject", launch.subject)
                .mapTo(String::class.java)
                .findOne()
                .getOrNull()
        }

    /** Makes the person one of the staff, with a token that nobody is told. */
    fun makeStaff(launch: Launch): String {
        val role = if (launch.role == LaunchRole.INSTRUCTOR) StaffRole.INSTRUCTOR else StaffRole.ASSISTANT
        val made = staff.add(nameOf(launch.name, "Staff"), role, "command", key = null)
        link(launch, made.id)
        return made.id
    }

    /** Remembers the account of the staff that the person has here. */
    fun link(
        launch: Launch,
        account: String,
    ) = database.write { handle ->
        handle
            .createUpdate(
                """INSERT INTO lti_staff (platform_id, subject, account_id) VALUES (:platform, :subject, :account)
                   ON CONFLICT (platform_id, subject) DO UPDATE SET account_id = excluded.account_id""",
            ).bind("platform", launch.platform)
            .bind("subject", launch.subject)
            .bind("account", account)
            .execute()
        AuditNote(account, course = null, "lti-staff", account, launch.subject).write(handle, clock.instant())
    }

    /** Remembers which exercise a link leads to and where its scores go. */
    fun keepLink(
        launch: Launch,
        exercise: String,
    ) {
        val link = launch.link ?: return
        database.write { handle ->
            handle
                .createUpdate(
                    """INSERT INTO lti_links (id, platform_id, context, link, exercise, line_item, line_items)
                       VALUES (:id, :platform, :context, :link, :exercise, :item, :items)
                       ON CONFLICT (platform_id, context, link) DO UPDATE SET exercise = excluded.exercise,
                           line_item = coalesce(excluded.line_item, lti_links.line_item),
                           line_items = excluded.line_items""",
                ).bind("id", Secrets.newId())
                .bind("platform", launch.platform)
                .bind("context", launch.context)
                .bind("link", link)
                .bind("exercise", exercise)
                .bind("item", launch.scores?.lineItem)
                .bind("items", launch.scores?.lineItems)
                .execute()
        }
    }

    private fun courseOf(
        handle: Handle,
        launch: Launch,
    ): Course? =
        handle
            .createQuery("SELECT course_id FROM lti_contexts WHERE platform_id = :platform AND context = :context")
            .bind("platform", launch.platform)
            .bind("context", launch.context)
            .mapTo(String::class.java)
            .findOne()
            .getOrNull()
            ?.let { Courses.course(handle, "id", it) }

    /** @param toldName what the platform called them last; null where it was not noted yet */
    private class KnownStudent(
        val student: String,
        val number: Int,
        val name: String,
        val toldName: String?,
    )

    private fun known(
        handle: Handle,
        launch: Launch,
        course: Course,
    ): KnownStudent? =
        handle
            .createQuery(
                """SELECT students.id, number, name, told_name FROM lti_students
                   JOIN students ON students.id = student_id
                   WHERE platform_id = :platform AND subject = :subject AND lti_students.course_id = :course""",
            ).bind("platform", launch.platform)
            .bind("subject", launch.subject)
            .bind("course", course.id)
            .map { row, _ ->
                KnownStudent(
                    row.getString("id"),
                    row.getInt("number"),
                    row.getString("name"),
                    row.getString("told_name"),
                )
            }.findOne()
            .getOrNull()

    private fun enrolled(
        handle: Handle,
        launch: Launch,
        course: Course,
    ): String {
        val number = launch.number
        if (number != null) ofRoster(handle, launch, course, number)?.let { return it }
        val rows = StudentRows(handle, course.id, clock.instant())
        return rows.add(nameOf(launch.name, "Student"), Secrets.newToken()).also { id ->
            if (number != null) rows.note(id, mapOf("id-number" to number))
            rows.write()
        }
    }

    private fun ofRoster(
        handle: Handle,
        launch: Launch,
        course: Course,
        number: String,
    ): String? =
        handle
            .createQuery(
                """SELECT DISTINCT students.id FROM students JOIN roster_fields ON roster_fields.student_id = students.id
                   WHERE students.course_id = :course AND kind IN ('id-number', 'sis-user-id') AND value = :number
                   AND NOT EXISTS (SELECT 1 FROM lti_students
                       WHERE lti_students.student_id = students.id AND platform_id = :platform)""",
            ).bind("course", course.id)
            .bind("number", number)
            .bind("platform", launch.platform)
            .mapTo(String::class.java)
            .list()
            .singleOrNull()

    private companion object {
        const val LONGEST_NAME = 80

        /** A name as it can stand here; [otherwise] where the platform's cannot. */
        fun nameOf(
            told: String,
            otherwise: String,
        ): Name = nameIn(told) ?: Name.of(otherwise)

        /** A name as it can stand here; null where it cannot. */
        fun nameIn(told: String): Name? {
            val cut = told.codePoints().limit(LONGEST_NAME.toLong()).toArray()
            return try {
                Name.of(String(cut, 0, cut.size))
            } catch (refused: Rejection.BadName) {
                null
            }
        }
    }
}
