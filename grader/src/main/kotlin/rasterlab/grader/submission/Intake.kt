package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.statement.Query
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Identity
import rasterlab.grader.limits.Allowance
import rasterlab.grader.limits.IntakeLimits
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.Arrival
import rasterlab.grader.rules.CourseLimits
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.SharedWrites
import rasterlab.grader.storage.text
import java.time.Duration
import java.time.Instant
import java.time.InstantSource

/**
 * A submission that is stored.
 *
 * @param allowance what is left of the student's minute
 */
data class Accepted(
    val id: String,
    val state: State,
    val position: Int,
    val allowance: Allowance,
)

/**
 * Stores submissions: when [accept] returns, the submission is on the disk.
 *
 * @param most what the server allows, of which a course may allow less
 */
class Intake(
    private val database: Database,
    private val most: IntakeLimits,
    private val clock: InstantSource,
) {
    private val together = SharedWrites(database)

    /**
     * @param key what the student calls this request, so that repeating it gives the same submission
     * @param late whether the student agrees that it is marked as late where the deadline has passed
     * @param most percent of its points that the student agrees to lose for that
     * @throws Rejection.Late where it has and the student does not
     */
    fun accept(
        student: Identity.StudentIdentity,
        exercise: Exercise,
        source: String,
        key: String?,
        late: Boolean = false,
        most: Int = ExerciseRules.PERCENT.last,
    ): Accepted {
        if (!database.hasRoom()) throw Rejection.NoRoom()
        val handedSeed = handedSeed(exercise, source)
        val request = Repeatable("submissions ${student.id}", key, "${exercise.id()}\n$source")
        return together.write { handle ->
            val before = allowance(handle, student.id)
            val earlier = request.made(handle)
            val id =
                earlier ?: run {
                    requireTaken(handle, student, exercise) { late && it <= most }
                    checkLimits(handle, student.id, before)
                    val rules = CourseRules.of(handle, student.id, exercise.id())
                    insert(handle, student.id, exercise, source, handedSeed, rules)
                        .also { request.remember(handle, it, clock.instant()) }
                }
            val state = checkNotNull(Submissions.find(handle, id)) { "submission $id was just stored" }.state
            val after = if (earlier == null) before.taken() else before
            Accepted(id, state, Submissions.position(handle, id), after)
        }
    }

    /**
     * Stores what is handed in at an exam, whose times hold in the place of the course's rules: it is in time.
     *
     * @param limited whether the student may hand in too much
     * @return the id of the submission
     */
    fun acceptAtExam(
        student: String,
        exercise: Exercise,
        source: String,
        key: String?,
        limited: Boolean,
    ): String {
        if (!database.hasRoom()) throw Rejection.NoRoom()
        val handedSeed = handedSeed(exercise, source)
        val request = Repeatable("submissions $student", key, "${exercise.id()}\n$source")
        return together.write { handle ->
            request.made(handle) ?: run {
                if (limited) checkLimits(handle, student, allowance(handle, student))
                insert(handle, student, exercise, source, handedSeed, ExerciseRules(due = clock.instant()))
                    .also { request.remember(handle, it, clock.instant()) }
            }
        }
    }

    private fun handedSeed(
        exercise: Exercise,
        source: String,
    ): Long? = if (exercise.form() == Exercise.TaskKind.PREDICT) Sheets.handedSeed(exercise, source) else null

    /**
     * Practice is free: it uses up no attempt, and none has to be left.
     *
     * @param agreed tells whether the student agrees that lateness costs that percentage, which may be 0
     */
    private fun requireTaken(
        handle: Handle,
        student: Identity.StudentIdentity,
        exercise: Exercise,
        agreed: (Int) -> Boolean,
    ) {
        val rules = CourseRules.of(handle, student.id, exercise.id())
        val now = clock.instant()
        rules.opens?.let { if (now < it) throw Rejection.NotOpen(exercise.id(), it, now) }
        val counts = rules.arrival(now) != Arrival.PRACTICE
        rules.attempts?.takeIf { counts && made(handle, student, exercise) >= it }?.let {
            throw Rejection.NoAttemptsLeft(exercise.id(), it)
        }
        if (!agreed(rules.penalty(now))) rules.lateness(now)?.let { throw Rejection.Late(checkNotNull(rules.due), it) }
    }

    private fun made(
        handle: Handle,
        student: Identity.StudentIdentity,
        exercise: Exercise,
    ) = count(student.id, handle.createQuery("$COUNT AND exercise = :exercise").bind("exercise", exercise.id()))

    /** @param rules that hold for the student */
    private fun insert(
        handle: Handle,
        student: String,
        exercise: Exercise,
        source: String,
        handedSeed: Long?,
        rules: ExerciseRules,
    ): String {
        handedSeed?.let { Sheets.requireSeed(it, Sheets.seed(handle, student, exercise)) }
        val id = Secrets.newId()
        val now = clock.instant()
        handle
            .createUpdate(
                """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state, round,
                       begins_turns, hint_cost, due_at, penalty_agreed, penalty)
                   SELECT :id, :student, :exercise, :revision, attempt, :source, :seed, :now, 'queued', turn.round,
                       CASE WHEN EXISTS (SELECT 1 FROM submissions WHERE state IN ('queued', 'running'))
                           AND EXISTS (SELECT 1 FROM submissions AS before
                               WHERE before.student_id = :student AND before.round = turn.round - 1) THEN 0 ELSE 1 END,
                       $HINTS, :due, :penalty, :penalty
                   FROM (SELECT $ROUND AS round) AS turn,
                       (SELECT coalesce(max(attempt), 0) + 1 AS attempt
                           FROM submissions WHERE student_id = :student AND exercise = :exercise) AS mine""",
            ).bind("id", id)
            .bind("student", student)
            .bind("exercise", exercise.id())
            .bind("revision", exercise.revision())
            .bind("source", source)
            .bind("seed", handedSeed ?: Secrets.newSeed())
            .bind("now", now.text())
            .bind("longAgo", (now - LONG_WAIT).text())
            .bind("due", rules.due?.text())
            .bind("penalty", rules.penalty(now))
            .execute()
        return id
    }

    private fun checkLimits(
        handle: Handle,
        student: String,
        allowance: Allowance,
    ) {
        val limits = CourseLimits.of(handle, student, most)
        val waiting = count(student, handle.createQuery("$COUNT AND state <> 'done'"))
        if (waiting >= limits.waiting) throw Rejection.TooManyQueued(limits.waiting, WAIT_SECONDS, allowance)
        if (allowance.left == 0) throw Rejection.TooFast(allowance)
    }

    /**
     * Returns what a student may still hand in. Only submissions up to now count: before the clock was set back, some
     * may have come at a time that is still to come.
     */
    private fun allowance(
        handle: Handle,
        student: String,
    ): Allowance {
        val now = clock.instant()
        val lately =
            handle
                .createQuery(LATELY)
                .bind("student", student)
                .bind("since", (now - MINUTE).text())
                .bind("now", now.text())
                .mapTo(String::class.java)
                .list()
        // Where fewer may come than a minute before, more than one has to leave the minute first.
        val allowed = CourseLimits.of(handle, student, most).perMinute
        val left = maxOf(allowed - lately.size, 0)
        val first = lately.getOrNull(maxOf(lately.size - allowed, 0))
        val refill = first?.let { Duration.between(now, Instant.parse(it) + MINUTE) } ?: Duration.ZERO
        return Allowance(allowed, left, MINUTE, refill)
    }

    private fun count(
        student: String,
        query: Query,
    ) = query.bind("student", student).mapTo(Int::class.javaObjectType).one()

    private companion object {
        /** Who has waited so long is not overtaken by one who comes now. */
        val LONG_WAIT: Duration = Duration.ofMinutes(1)

        /**
         * The round that grading has come to, or the one after this student's last. Where nothing waits, all begin anew:
         * what somebody handed in before is not held against them. Who comes first in a round keeps their place before
         * those who come later, and nobody comes before the first of a student who has waited long.
         */
        const val ROUND =
            """(SELECT coalesce(max(come), 0) FROM (
                   SELECT max(round) AS come FROM submissions WHERE state = 'running'
                   UNION ALL SELECT max(round) FROM submissions WHERE state = 'done'
                   UNION ALL SELECT max(round) FROM submissions WHERE state = 'queued' AND begins_turns = 1
                   UNION ALL SELECT (SELECT max(round) FROM submissions WHERE state = 'done') + 1
                       WHERE NOT EXISTS (SELECT 1 FROM submissions WHERE state IN ('queued', 'running'))
                   UNION ALL SELECT max(first) FROM (
                       SELECT min(round) AS first FROM submissions
                       WHERE state = 'queued' AND received_at <= :longAgo GROUP BY student_id) AS firsts
                   UNION ALL SELECT max(round) + 1 FROM submissions WHERE student_id = :student) AS rounds)"""

        /** The cost of the hints that were shown to the student by now. */
        const val HINTS =
            "(SELECT coalesce(sum(cost), 0) FROM hints WHERE student_id = :student AND exercise = :exercise)"

        const val COUNT = "SELECT count(*) FROM submissions WHERE student_id = :student"

        const val LATELY =
            """SELECT received_at FROM submissions
               WHERE student_id = :student AND received_at > :since AND received_at <= :now ORDER BY received_at"""

        const val WAIT_SECONDS = 5
        val MINUTE: Duration = Duration.ofMinutes(1)
    }
}
