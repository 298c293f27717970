package rasterlab.grader.rules

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * A later deadline of one student.
 *
 * @param student id
 * @param name as the course shows it
 */
data class Extension(
    val student: String,
    val name: String,
    val exercise: String,
    val due: Instant,
    val reason: String,
)

/**
 * Keeps what a course rules for its exercises. What comes after the deadline is taken where the student agrees to that,
 * graded all the same, and marked as late; and what hidden cases found is shown with everything when nothing that
 * counts can come any more.
 */
class CourseRules(
    private val database: Database,
    private val clock: InstantSource,
) {
    /** The rules that hold for whoever asks, by exercise; none for an instructor. */
    fun of(who: Identity): Map<String, ExerciseRules> =
        if (who is Identity.StudentIdentity) ofStudent(who.id) else emptyMap()

    private fun ofStudent(student: String): Map<String, ExerciseRules> =
        database.read { handle ->
            handle
                .createQuery(
                    "SELECT rules.exercise, ${ExerciseRules.COLUMNS} FROM $OF_STUDENTS WHERE students.id = :student",
                ).bind("student", student)
                .map { row, _ -> row.getString("exercise") to ExerciseRules.of(row) }
                .list()
                .toMap()
        }

    /** The rules of an exercise for a student. */
    fun of(
        student: String,
        exercise: String,
    ): ExerciseRules = database.read { of(it, student, exercise) }

    /**
     * Tells after which moment hidden cases of an exercise are shown to a student: nobody in the course, whatever
     * extension they have, can make anything of them then that counts and is not marked as late. Null for never.
     */
    fun shows(
        student: String,
        exercise: String,
    ): Instant? =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT ${ExerciseRules.COLUMNS}
                       FROM students JOIN course_exercises AS rules ON rules.course_id = students.course_id
                       LEFT JOIN (SELECT course_id, exercise, max(due_at) AS due_at
                                  FROM extensions JOIN students ON students.id = student_id
                                  GROUP BY course_id, exercise) AS extensions
                           ON extensions.course_id = rules.course_id AND extensions.exercise = rules.exercise
                       WHERE students.id = :student AND rules.exercise = :exercise""",
                ).bind("student", student)
                .bind("exercise", exercise)
                .map { row, _ -> ExerciseRules.of(row) }
                .findOne()
                .getOrNull()
                ?.ends
        }

    /** The rules of a course for everybody, by exercise. */
    fun ofCourse(course: Course): Map<String, ExerciseRules> = database.read { ofCourse(it, course) }

    /**
     * Changes the rules of an exercise.
     *
     * @param by who does it, for the audit
     */
    fun change(
        course: Course,
        exercise: String,
        change: RuleChange,
        by: String,
    ): ExerciseRules =
        database.write { handle ->
            val before = ofCourse(handle, course, exercise)
            val after = change.of(before)
            if (after != before) {
                store(handle, course, exercise, after)
                LatePenalties.settle(handle, course, exercise)
                note(handle, course, by, "rules", exercise, changes(before, after))
            }
            after
        }

    /** The extensions of a course. */
    fun extensions(course: Course): List<Extension> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT students.id, students.shown_name, exercise, due_at, reason
                       FROM extensions JOIN students ON students.id = student_id
                       WHERE course_id = :course ORDER BY exercise, number""",
                ).bind("course", course.id)
                .map { row, _ ->
                    Extension(
                        row.getString("id"),
                        row.getString("shown_name"),
                        row.getString("exercise"),
                        Instant.parse(row.getString("due_at")),
                        row.getString("reason"),
                    )
                }.list()
        }

    /**
     * Gives one student more time, or takes back what was given.
     *
     * @param until the deadline as somebody wrote it, in the zone of the exercise; empty to take it back
     * @param by who does it, for the audit
     * @return the rules that hold for the student now
     */
    fun extend(
        course: Course,
        exercise: String,
        student: String,
        until: String,
        reason: String,
        by: String,
    ): ExerciseRules =
        database.write { handle ->
            requireStudent(handle, course, student)
            val rules = ofCourse(handle, course, exercise)
            handle
                .createUpdate("DELETE FROM extensions WHERE student_id = :student AND exercise = :exercise")
                .bind("student", student)
                .bind("exercise", exercise)
                .execute()
            val due = if (until.isBlank()) null else extended(rules, exercise, until.trim())
            if (due != null) insert(handle, exercise, student, due, reasonOf(reason))
            LatePenalties.settle(handle, course, exercise)
            note(handle, course, by, "extension", "$exercise $student", due?.text().orEmpty())
            of(handle, student, exercise)
        }

    private fun extended(
        rules: ExerciseRules,
        exercise: String,
        until: String,
    ): Instant {
        val due = rules.due ?: throw Rejection.BadRule("no.deadline", exercise)
        val later = RuleChange.moment(RuleField.DEADLINE.code, until, rules.zone)
        if (later <= due) throw Rejection.BadRule("earlier", later.withOffset(rules.zone), due.withOffset(rules.zone))
        return later
    }

    private fun reasonOf(text: String): String =
        text.trim().takeIf { it.length in 1..MOST_REASON }
            ?: throw Rejection.BadRule("reason", text.trim().length, MOST_REASON)

    private fun insert(
        handle: Handle,
        exercise: String,
        student: String,
        due: Instant,
        reason: String,
    ) {
        handle
            .createUpdate(
                """INSERT INTO extensions (student_id, exercise, due_at, reason)
                   VALUES (:student, :exercise, :due, :reason)""",
            ).bind("student", student)
            .bind("exercise", exercise)
            .bind("due", due.text())
            .bind("reason", reason)
            .execute()
    }

    private fun requireStudent(
        handle: Handle,
        course: Course,
        student: String,
    ) {
        val found =
            handle
                .createQuery("SELECT count(*) FROM students WHERE id = :student AND course_id = :course")
                .bind("student", student)
                .bind("course", course.id)
                .mapTo(Int::class.javaObjectType)
                .one()
        if (found == 0) throw Rejection.UnknownStudent(student)
    }

    private fun note(
        handle: Handle,
        course: Course,
        by: String,
        action: String,
        subject: String,
        detail: String,
    ) = AuditNote(by, course.id, action, subject, detail).write(handle, clock.instant())

    /** The rules that changed, each with what it was and what it is. */
    private fun changes(
        before: ExerciseRules,
        after: ExerciseRules,
    ): String =
        (values(before) zip values(after)).filter { (one, other) -> one != other }.joinToString { (one, other) ->
            "${one.first.code}: ${one.second} → ${other.second}"
        }

    private fun values(rules: ExerciseRules): List<Pair<RuleField, String>> =
        listOf(
            RuleField.OPENS to rules.opens,
            RuleField.DEADLINE to rules.due,
            RuleField.ZONE to rules.zone.named(),
            RuleField.LATE_DAYS to rules.lateDays,
            RuleField.ATTEMPTS to rules.attempts,
            RuleField.POLICY to rules.policy.code,
            RuleField.LATE_PENALTY to rules.latePenalty,
        ).map { (field, value) -> field to (value?.toString() ?: "–") }

    private fun ofCourse(
        handle: Handle,
        course: Course,
        exercise: String,
    ): ExerciseRules =
        handle
            .createQuery("SELECT * FROM course_exercises WHERE course_id = :course AND exercise = :exercise")
            .bind("course", course.id)
            .bind("exercise", exercise)
            .map { row, _ -> ExerciseRules.of(row) }
            .findOne()
            .getOrNull() ?: ExerciseRules()

    companion object {
        private const val MOST_REASON = 200

        private const val OF_STUDENTS =
            """students JOIN course_exercises AS rules ON rules.course_id = students.course_id
               LEFT JOIN extensions ON extensions.student_id = students.id AND extensions.exercise = rules.exercise"""

        /** The rules of a course for everybody, by exercise, within a transaction. */
        internal fun ofCourse(
            handle: Handle,
            course: Course,
        ): Map<String, ExerciseRules> =
            handle
                .createQuery("SELECT * FROM course_exercises WHERE course_id = :course ORDER BY exercise")
                .bind("course", course.id)
                .map { row, _ -> row.getString("exercise") to ExerciseRules.of(row) }
                .list()
                .toMap()

        /** Puts rules in the place of those that an exercise had in a course. */
        internal fun store(
            handle: Handle,
            course: Course,
            exercise: String,
            rules: ExerciseRules,
        ) {
            handle
                .createUpdate(
                    """INSERT INTO course_exercises (course_id, exercise, opens_at, due_at, zone, late_days, attempts, policy, late_penalty)
                       VALUES (:course, :exercise, :opens, :due, :zone, :days, :attempts, :policy, :penalty)
                       ON CONFLICT (course_id, exercise) DO UPDATE SET opens_at = excluded.opens_at, due_at = excluded.due_at,
                           zone = excluded.zone, late_days = excluded.late_days, attempts = excluded.attempts,
                           policy = excluded.policy, late_penalty = excluded.late_penalty""",
                ).bind("course", course.id)
                .bind("exercise", exercise)
                .bind("opens", rules.opens?.text())
                .bind("due", rules.due?.text())
                .bind("zone", rules.zone.named())
                .bind("days", rules.lateDays)
                .bind("attempts", rules.attempts)
                .bind("policy", rules.policy.code)
                .bind("penalty", rules.latePenalty)
                .execute()
        }

        /** The rules of an exercise for a student, within a transaction. */
        fun of(
            handle: Handle,
            student: String,
            exercise: String,
        ): ExerciseRules =
            handle
                .createQuery(
                    """SELECT ${ExerciseRules.COLUMNS} FROM $OF_STUDENTS
                       WHERE students.id = :student AND rules.exercise = :exercise""",
                ).bind("student", student)
                .bind("exercise", exercise)
                .map { row, _ -> ExerciseRules.of(row) }
                .findOne()
                .getOrNull() ?: ExerciseRules()
    }
}
