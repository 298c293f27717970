package rasterlab.grader.course

import io.ktor.server.routing.Route
import io.ktor.server.routing.patch
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import org.jdbi.v3.core.Handle
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import java.time.Instant
import java.time.format.DateTimeParseException
import kotlin.jvm.optionals.getOrNull

/**
 * Says until when a course's students are to hand in. What comes later is taken where the student agrees to that, graded
 * all the same, and marked as late; and what hidden cases found is shown with everything from then on.
 */
class Deadlines(
    private val database: Database,
) {
    /** Deadlines by exercise in the course of whoever asks; an instructor has none. */
    fun of(who: Identity): Map<String, Instant> = if (who is Identity.Student) ofCourseOf(who) else emptyMap()

    private fun ofCourseOf(student: Identity.Student): Map<String, Instant> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT rules.exercise, $DUE AS due_at FROM $RULES WHERE students.id = :student AND $DUE IS NOT NULL""",
                ).bind("student", student.id)
                .map { row, _ -> row.getString("exercise") to Instant.parse(row.getString("due_at")) }
                .list()
                .toMap()
        }

    /** The deadline of an exercise in the course of a student, or null where there is none. */
    fun of(
        student: String,
        exercise: String,
    ): Instant? = database.read { of(it, student, exercise) }

    /**
     * Sets the deadline of an exercise, or takes it away.
     *
     * @throws Rejection.UnknownCourse where there is no course of that id
     */
    fun set(
        course: String,
        exercise: String,
        due: Instant?,
    ) = database.write { handle ->
        val courses =
            handle
                .createQuery("SELECT count(*) FROM courses WHERE id = :course")
                .bind("course", course)
                .mapTo(Int::class.javaObjectType)
                .one()
        if (courses == 0) throw Rejection.UnknownCourse(course)
        handle
            .createUpdate(
                """INSERT INTO course_exercises (course_id, exercise, due_at) VALUES (:course, :exercise, :due)
                   ON CONFLICT (course_id, exercise) DO UPDATE SET due_at = excluded.due_at""",
            ).bind("course", course)
            .bind("exercise", exercise)
            .bind("due", due?.text())
            .execute()
    }

    companion object {
        /** The deadline that holds for a student: that of the course, unless this student was given another. */
        private const val DUE = "coalesce(extensions.due_at, rules.due_at)"

        private const val RULES =
            """students JOIN course_exercises AS rules ON rules.course_id = students.course_id
               LEFT JOIN extensions ON extensions.student_id = students.id AND extensions.exercise = rules.exercise"""

        /** The same within a transaction. */
        fun of(
            handle: Handle,
            student: String,
            exercise: String,
        ): Instant? =
            handle
                .createQuery(
                    """SELECT $DUE FROM $RULES
                       WHERE students.id = :student AND rules.exercise = :exercise AND $DUE IS NOT NULL""",
                ).bind("student", student)
                .bind("exercise", exercise)
                .mapTo(String::class.java)
                .findOne()
                .map { Instant.parse(it) }
                .getOrNull()
    }
}

@Serializable
private data class DeadlineAnswer(
    val exercise: String,
    val deadline: String?,
)

/**
 * Serves deadlines to instructors, inside `authenticate`.
 *
 * @param known throws the rejection of an exercise that there is not
 */
fun Route.deadlines(
    deadlines: Deadlines,
    known: (String) -> Unit,
) = patch("/courses/{course}/exercises/{id}") {
    call.instructor()
    val exercise = call.parameters.getOrFail("id").also(known)
    val due = call.receiveJson("deadline") { moment(it.anyText("deadline")) }
    deadlines.set(call.parameters.getOrFail("course"), exercise, due)
    call.respondJson(DeadlineAnswer(exercise, due?.text()))
}

/** The moment that is meant; "" for none. */
private fun moment(told: String): Instant? =
    try {
        told.takeIf { it.isNotEmpty() }?.let { Instant.parse(it) }
    } catch (misfit: DateTimeParseException) {
        throw Rejection.BadDeadline(told)
    }
