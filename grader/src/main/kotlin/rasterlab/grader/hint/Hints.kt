/*
 * Help in steps: who was shown which, and what it costs in what is handed in afterwards.
 * Read Hints, then HintRoutes; Intake charges a submission for them.
 */
package rasterlab.grader.hint

import org.jdbi.v3.core.Handle
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.text
import java.time.Instant
import java.time.InstantSource

/** A step that a student was shown; the cost is the one of that moment. */
data class TakenHint(
    val step: Int,
    val cost: Int,
    val takenAt: Instant,
)

/** A step that one student of a class was shown. */
data class HintUse(
    val student: String,
    val name: String,
    val exercise: String,
    val hint: TakenHint,
)

/** Records which steps students were shown. */
class Hints(
    private val database: Database,
    private val clock: InstantSource,
) {
    /** The steps that the student was shown, in their order. */
    fun taken(
        student: Identity.StudentIdentity,
        exercise: Exercise,
    ): List<TakenHint> = database.read { taken(it, student, exercise) }

    /**
     * Shows the next step. Asked for by a step that is shown already, nothing changes.
     *
     * @param step the one that was confirmed; null for whichever is next
     * @param key what the student calls this request, so that repeating it takes no other step
     * @return the steps that are shown now
     * @throws Rejection.NoMoreHints when all are shown
     * @throws Rejection.HintOrder when a step before that one is not shown yet
     */
    fun take(
        student: Identity.StudentIdentity,
        exercise: Exercise,
        step: Int? = null,
        key: String? = null,
    ): List<TakenHint> {
        if (!database.hasRoom()) throw Rejection.NoRoom()
        val request = Repeatable("hints ${student.id}", key, "${exercise.id()} ${step ?: "next"}")
        return database.write { handle ->
            val shown = taken(handle, student, exercise)
            val next = shown.size + 1
            val wanted = step ?: next
            if (request.made(handle) != null || wanted in 1..shown.size) return@write shown
            if (next > exercise.hints().size) throw Rejection.NoMoreHints(exercise.id(), exercise.hints().size)
            if (wanted != next) throw Rejection.HintOrder(wanted, next)
            val hint = TakenHint(next, exercise.hints()[next - 1].cost(), clock.instant())
            insert(handle, student, exercise, hint)
            request.remember(handle, "$next", hint.takenAt)
            taken(handle, student, exercise)
        }
    }

    /** The hints that were shown to the students of a course in an exercise, the earliest first. */
    fun ofCourse(
        course: String,
        exercise: String,
    ): List<HintUse> =
        uses(
            """WHERE students.course_id = :course AND hints.exercise = :exercise
               ORDER BY taken_at, step, hints.student_id""",
            mapOf("course" to course, "exercise" to exercise),
        )

    /** The hints that were shown lately, the latest first. */
    fun latest(who: Identity.StaffIdentity): List<HintUse> {
        val whose = if (who.onlyCourse == null) "" else "WHERE students.course_id = :course"
        val course = listOfNotNull(who.onlyCourse).associateBy { "course" }
        return uses("$whose ORDER BY taken_at DESC, step DESC LIMIT $LISTED", course)
    }

    private fun insert(
        handle: Handle,
        student: Identity.StudentIdentity,
        exercise: Exercise,
        hint: TakenHint,
    ) {
        handle
            .createUpdate(
                """INSERT INTO hints (student_id, exercise, step, cost, taken_at)
                   VALUES (:student, :exercise, :step, :cost, :now)""",
            ).bind("student", student.id)
            .bind("exercise", exercise.id())
            .bind("step", hint.step)
            .bind("cost", hint.cost)
            .bind("now", hint.takenAt.text())
            .execute()
    }

    private fun taken(
        handle: Handle,
        student: Identity.StudentIdentity,
        exercise: Exercise,
    ): List<TakenHint> =
        handle
            .createQuery(
                """SELECT step, cost, taken_at FROM hints
                   WHERE student_id = :student AND exercise = :exercise ORDER BY step""",
            ).bind("student", student.id)
            .bind("exercise", exercise.id())
            .map { row, _ ->
                TakenHint(row.getInt("step"), row.getInt("cost"), Instant.parse(row.getString("taken_at")))
            }.list()

    private fun uses(
        condition: String,
        bindings: Map<String, Any>,
    ): List<HintUse> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT student_id, students.shown_name, exercise, step, cost, taken_at
                       FROM hints JOIN students ON students.id = student_id $condition""",
                ).bindMap(bindings)
                .map { row, _ ->
                    HintUse(
                        row.getString("student_id"),
                        row.getString("shown_name"),
                        row.getString("exercise"),
                        TakenHint(row.getInt("step"), row.getInt("cost"), Instant.parse(row.getString("taken_at"))),
                    )
                }.list()
        }

    private companion object {
        const val LISTED = 100
    }
}
