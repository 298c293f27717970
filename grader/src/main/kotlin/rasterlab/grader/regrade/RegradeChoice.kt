package rasterlab.grader.regrade

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.Course
import rasterlab.grader.problem.Rejection
import rasterlab.grader.submission.Submissions

/**
 * A submission that has a result.
 *
 * @param points of its current result, less what hints cost
 */
class Gradable(
    val submission: String,
    val student: String,
    val name: String,
    val attempt: Int,
    val points: Int,
    val of: Int,
) {
    internal companion object {
        fun all(
            handle: Handle,
            course: Course,
            exercise: String,
        ): List<Gradable> =
            handle
                .createQuery(
                    """SELECT s.id, s.student_id, students.shown_name, s.attempt, ${Submissions.NET} AS points, r.points_of
                       FROM submissions s
                       JOIN students ON students.id = s.student_id
                       JOIN results r ON r.submission_id = s.id AND r.is_current = 1
                       WHERE students.course_id = :course AND s.exercise = :exercise AND s.state = 'done'
                       ORDER BY s.sequence""",
                ).bind("course", course.id)
                .bind("exercise", exercise)
                .map { row, _ ->
                    Gradable(
                        row.getString("id"),
                        row.getString("student_id"),
                        row.getString("shown_name"),
                        row.getInt("attempt"),
                        row.getInt("points"),
                        row.getInt("points_of"),
                    )
                }.list()
    }
}

/** Which submissions are graded again: each, one of each student, or those that are named. */
enum class RegradeChoice {
    ALL,
    LATEST,
    BEST,
    SOME,
    ;

    /** Lower-case, as stored and in the HTTP API. */
    val code get() = name.lowercase()

    /**
     * @param graded in the order of handing in
     * @param some ids, for [SOME]
     */
    internal fun of(
        graded: List<Gradable>,
        some: Collection<String>,
    ): List<Gradable> {
        val chosen =
            when (this) {
                ALL -> graded
                LATEST -> graded.groupBy { it.student }.map { it.value.last() }
                BEST -> graded.groupBy { it.student }.map { of -> of.value.maxBy { it.points } }
                SOME -> named(graded, some)
            }
        if (chosen.isEmpty()) throw Rejection.BadRegrade("nothing")
        return chosen
    }

    private fun named(
        graded: List<Gradable>,
        some: Collection<String>,
    ): List<Gradable> {
        if (some.isEmpty()) throw Rejection.BadRegrade("unnamed")
        val known = graded.mapTo(mutableSetOf()) { it.submission }
        some.firstOrNull { it !in known }?.let { throw Rejection.BadRegrade("submission", it) }
        return graded.filter { it.submission in some }
    }

    companion object {
        /** @throws Rejection.BadRegrade where it names no choice */
        fun named(code: String): RegradeChoice =
            entries.firstOrNull { it.code == code }
                ?: throw Rejection.BadRegrade("choice", code, (entries - SOME).joinToString { it.code })
    }
}
