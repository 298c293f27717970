package rasterlab.grader.rules

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import java.time.InstantSource

/**
 * Keeps which exercises a course has: all that the server has, or those that an instructor chose.
 *
 * @param all the ids of the exercises that the server has
 */
class CourseExercises(
    private val database: Database,
    private val all: List<String>,
    private val clock: InstantSource,
) {
    /** The ids of the exercises that a course has, in the server's order. */
    fun of(course: String): List<String> = database.read { of(it, course) }

    /** The ids of the exercises that marks may come from: those that a course has, and those of its exams. */
    fun graded(course: String): List<String> =
        database.read { handle ->
            val had = of(handle, course) + ofExams(handle, course)
            all.filter(had.toSet()::contains)
        }

    /** The ids of the exercises that somebody does not get, since the course does not have them. */
    fun closedTo(who: Identity): Set<String> =
        if (who is Identity.StudentIdentity) all.toSet() - of(who.course).toSet() else emptySet()

    /**
     * Chooses the exercises of a course. What was handed in for one that it does not have any more stays, and gives no
     * marks.
     *
     * @param chosen ids of exercises; null, or each of them, for all that the server has, now and later
     * @param by who does it, for the audit
     * @throws Rejection.UnknownExercise where the server lacks one
     * @throws Rejection.BadRule where there is none
     */
    fun choose(
        course: Course,
        chosen: Collection<String>?,
        by: String,
    ): List<String> {
        if (chosen?.isEmpty() == true) throw Rejection.BadRule("no.exercise", "exercises")
        chosen?.firstOrNull { it !in all }?.let { throw Rejection.UnknownExercise(it) }
        val stored = chosen?.toSet()?.takeUnless { it.containsAll(all) }.orEmpty()
        return database.write { handle ->
            if (store(handle, course, stored)) {
                val detail = stored.joinToString().ifEmpty { "–" }
                AuditNote(by, course.id, "exercises", course.id, detail).write(handle, clock.instant())
            }
            of(handle, course.id)
        }
    }

    private fun of(
        handle: Handle,
        course: String,
    ): List<String> =
        stored(handle, course).let { chosen ->
            if (chosen.isEmpty()) all else all.filter(chosen::contains)
        }

    private fun ofExams(
        handle: Handle,
        course: String,
    ): List<String> =
        handle
            .createQuery(
                "SELECT exercise FROM exam_exercises JOIN exams ON exams.id = exam_id WHERE course_id = :course",
            ).bind("course", course)
            .mapTo(String::class.java)
            .list()

    companion object {
        /** Gives a course the choice of another, within a transaction. */
        internal fun copy(
            handle: Handle,
            from: Course,
            to: Course,
        ) = store(handle, to, stored(handle, from.id))

        /** @return whether that changes anything */
        private fun store(
            handle: Handle,
            course: Course,
            chosen: Set<String>,
        ): Boolean {
            if (stored(handle, course.id) == chosen) return false
            handle
                .createUpdate("DELETE FROM chosen_exercises WHERE course_id = :course")
                .bind("course", course.id)
                .execute()
            val insert =
                handle.prepareBatch("INSERT INTO chosen_exercises (course_id, exercise) VALUES (:course, :exercise)")
            chosen.forEach { insert.bind("course", course.id).bind("exercise", it).add() }
            if (chosen.isNotEmpty()) insert.execute()
            return true
        }

        /** The ids that somebody chose; none where the course has all. */
        private fun stored(
            handle: Handle,
            course: String,
        ): Set<String> =
            handle
                .createQuery("SELECT exercise FROM chosen_exercises WHERE course_id = :course")
                .bind("course", course)
                .mapTo(String::class.java)
                .set()
    }
}
