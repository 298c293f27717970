package rasterlab.grader.classroom

import rasterlab.grader.hint.Hints
import rasterlab.grader.storage.Database
import rasterlab.grader.submission.Submissions
import java.time.Instant

/**
 * How a student gets on with an exercise.
 *
 * @param attempts with a result
 * @param best the most points of them that count: after hints and lateness, with points by hand
 * @param withoutGain attempts since the first one with these points
 * @param hints steps that were shown
 */
data class Effort(
    val student: String,
    val name: String,
    val attempts: Int,
    val best: Int,
    val of: Int,
    val passed: Boolean,
    val withoutGain: Int,
    val lastAt: Instant,
    val hints: Int,
    val hintCost: Int,
) {
    /** Whether the last attempts led nowhere. */
    val stuck get() = !passed && withoutGain >= STUCK

    companion object {
        /** Attempts in a row without a gain, from which somebody is called stuck. */
        const val STUCK = 3
    }
}

/**
 * A step of the hints.
 *
 * @param shown to how many students
 * @param passed how many of them passed
 */
data class HintEffect(
    val step: Int,
    val shown: Int,
    val passed: Int,
)

/** The efforts of a class, those first who are stuck for longest; whoever handed nothing in has none. */
class ClassEfforts(
    val efforts: List<Effort>,
    val hints: List<HintEffect>,
) {
    /** The students who never passed. */
    val open: List<Effort> = efforts.filterNot { it.passed }
}

/** Reads who is stuck where. */
class Efforts(
    private val database: Database,
    private val hints: Hints,
) {
    /** The efforts of a course's students in an exercise. */
    fun of(
        course: String,
        exercise: String,
    ): ClassEfforts {
        val taken = hints.ofCourse(course, exercise).groupBy { it.student }
        val efforts =
            attempts(course, exercise)
                .groupBy { it.student }
                .map { (student, all) ->
                    val shown = taken[student].orEmpty()
                    effort(all, shown.size, shown.sumOf { it.hint.cost })
                }.sortedWith(
                    compareByDescending<Effort> { it.stuck }
                        .thenByDescending { it.withoutGain }
                        .thenByDescending { it.attempts }
                        .thenBy { it.name },
                )
        val passed = efforts.filter { it.passed }.map { it.student }.toSet()
        val steps =
            taken.values.flatten().groupBy { it.hint.step }.toSortedMap().map { (step, uses) ->
                HintEffect(step, uses.size, uses.count { it.student in passed })
            }
        return ClassEfforts(efforts, steps)
    }

    private fun effort(
        inOrder: List<Attempt>,
        hints: Int,
        hintCost: Int,
    ): Effort {
        val best = inOrder.maxOf { it.points }
        val last = inOrder.last()
        return Effort(
            last.student,
            last.name,
            inOrder.size,
            best,
            last.of,
            inOrder.any { it.passed },
            inOrder.size - 1 - inOrder.indexOfFirst { it.points == best },
            last.at,
            hints,
            hintCost,
        )
    }

    private class Attempt(
        val student: String,
        val name: String,
        val points: Int,
        val of: Int,
        val passed: Boolean,
        val at: Instant,
    )

    private fun attempts(
        course: String,
        exercise: String,
    ): List<Attempt> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT students.id, students.shown_name, s.received_at, r.verdict, r.points_of,
                           ${Submissions.NET} AS points
                       FROM students
                       JOIN submissions AS s ON s.student_id = students.id AND s.exercise = :exercise
                       JOIN results AS r ON r.submission_id = s.id AND r.is_current = 1
                       WHERE students.course_id = :course AND r.verdict <> 'internal' ORDER BY s.sequence""",
                ).bind("course", course)
                .bind("exercise", exercise)
                .map { row, _ ->
                    Attempt(
                        row.getString("id"),
                        row.getString("shown_name"),
                        row.getInt("points"),
                        row.getInt("points_of"),
                        row.getString("verdict") == "ok",
                        Instant.parse(row.getString("received_at")),
                    )
                }.list()
        }
}
