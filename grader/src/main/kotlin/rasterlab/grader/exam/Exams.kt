package rasterlab.grader.exam

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.named
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.text
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource
import java.time.ZoneId
import kotlin.jvm.optionals.getOrNull

/**
 * A student's line on the page of an exam.
 *
 * @param name as the course shows it
 */
class SeatedStudent(
    val name: String,
    val sitting: Sitting,
)

/** Keeps the exams of courses, and what staff do with them. */
class Exams(
    private val database: Database,
    private val clock: InstantSource,
) {
    /**
     * Stores a new exam.
     *
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it makes no other exam
     * @throws Rejection.BadExam where one of its exercises is in another exam that is not over
     */
    fun create(
        course: Course,
        form: ExamForm,
        by: String,
        key: String?,
    ): Exam {
        val exam = form.exam(course)
        val request = Repeatable("exams $by", key, "${course.id} ${ExamForm.told(exam)} ${exam.exercises}")
        return database.write { handle ->
            request.made(handle)?.let { return@write find(handle, it) ?: throw Rejection.UnknownExam(it) }
            store(handle, exam, taken = closed(handle, course.id, clock.instant()))
            audit(handle, exam, by, "exam", "${exam.name}: ${exam.exercises.joinToString()}")
            request.remember(handle, exam.id, clock.instant())
            exam
        }
    }

    /**
     * Changes an exam, also one that runs: whoever works on it has the new end at once. Who has ended does not go on.
     *
     * @param told what is to be changed; what is not told stays
     * @param exercises their ids; null for those that it has
     * @param by who does it, for the audit
     * @throws Rejection.BadExam where that cannot be, or not any more
     */
    fun change(
        id: String,
        told: Map<ExamField, String>,
        exercises: List<String>?,
        by: String,
    ): Exam =
        database.write { handle ->
            val before = find(handle, id) ?: throw Rejection.UnknownExam(id)
            val after = ExamForm.changed(before, told, exercises, begun(handle, id) > 0)
            if (after != before) {
                val others = ofCourse(handle, before.course).filter { it.id != id }
                store(handle, after, taken = closed(handle, others, clock.instant()))
                audit(handle, after, by, "exam-change", changes(before, after))
            }
            after
        }

    /**
     * Ends an exam for everybody who has no more minutes than others; their last texts are handed in.
     *
     * @param by who does it, for the audit
     * @throws Rejection.BadExam where it has not begun
     */
    fun end(
        id: String,
        by: String,
    ): Exam = change(id, mapOf(ExamField.CLOSES to clock.instant().text()), exercises = null, by)

    /** Stores an exam in the place of what it was. */
    private fun store(
        handle: Handle,
        exam: Exam,
        taken: Set<String>,
    ) {
        exam.exercises.firstOrNull(taken::contains)?.let { throw Rejection.BadExam("taken", it) }
        handle
            .createUpdate(
                """INSERT INTO exams (id, course_id, name, opens_at, closes_at, zone, minutes, is_fixed, grace,
                       addresses, takes_over)
                   VALUES (:id, :course, :name, :opens, :closes, :zone, :minutes, :fixed, :grace,
                       :addresses, :over)
                   ON CONFLICT (id) DO UPDATE SET name = excluded.name, opens_at = excluded.opens_at,
                       closes_at = excluded.closes_at, zone = excluded.zone, minutes = excluded.minutes,
                       is_fixed = excluded.is_fixed, grace = excluded.grace, addresses = excluded.addresses,
                       takes_over = excluded.takes_over""",
            ).bind("id", exam.id)
            .bind("course", exam.course)
            .bind("name", exam.name)
            .bind("opens", exam.opens.text())
            .bind("closes", exam.closes.text())
            .bind("zone", exam.zone.named())
            .bind("minutes", exam.minutes)
            .bind("fixed", if (exam.fixed) 1 else 0)
            .bind("grace", exam.grace)
            .bind("addresses", exam.addresses.text)
            .bind("over", if (exam.takesOver) 1 else 0)
            .execute()
        handle.createUpdate("DELETE FROM exam_exercises WHERE exam_id = :exam").bind("exam", exam.id).execute()
        exam.exercises.forEachIndexed { position, exercise ->
            handle
                .createUpdate(
                    """INSERT INTO exam_exercises (exam_id, exercise, position)
                       VALUES (:exam, :exercise, :position)""",
                ).bind("exam", exam.id)
                .bind("exercise", exercise)
                .bind("position", position)
                .execute()
        }
    }

    /** The fields that changed, each with what it was and what it is. */
    private fun changes(
        before: Exam,
        after: Exam,
    ): String {
        val (old, new) = listOf(before, after).map(ExamForm::told)
        val fields = old.keys.filter { old[it] != new[it] }.map { "${it.code}: ${old[it]} → ${new[it]}" }
        val exercises = "exercises: ${after.exercises.joinToString()}".takeIf { before.exercises != after.exercises }
        return (fields + listOfNotNull(exercises)).joinToString()
    }

    fun ofCourse(course: String): List<Exam> = database.read { ofCourse(it, course) }

    /** @throws Rejection.UnknownExam */
    fun find(id: String): Exam = database.read { find(it, id) } ?: throw Rejection.UnknownExam(id)

    /** All students of the exam's course, in the order of their numbers. */
    fun seats(exam: Exam): List<SeatedStudent> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT students.id AS student, students.shown_name, s.* FROM students
                       LEFT JOIN exam_sittings s ON s.student_id = students.id AND s.exam_id = :exam
                       WHERE students.course_id = :course ORDER BY students.number""",
                ).bind("exam", exam.id)
                .bind("course", exam.course)
                .map { row, _ ->
                    SeatedStudent(row.getString("shown_name"), sitting(exam, row.getString("student"), row))
                }.list()
        }

    /** The protocol, in order. */
    fun events(exam: Exam): List<ExamEvent> = database.read { ExamEvents.of(it, exam.id) }

    /**
     * Gives a student minutes more than others have; who has ended goes on where the new end is still to come.
     *
     * @param by who does it, for the audit
     */
    fun give(
        exam: Exam,
        student: String,
        minutes: String,
        by: String,
    ) {
        val extra = ExamForm.number("extra", minutes, Exam.EXTRA)
        database.write { handle ->
            seat(handle, exam, student)
            update(handle, exam, student, "extra = :value", extra)
            val sitting = sitting(handle, exam, student)
            if (sitting.ended != null && clock.instant() < checkNotNull(sitting.ends)) {
                update(handle, exam, student, "ended_at = :value", null)
            }
            note(handle, exam, student, by, ExamEventKind.EXTRA, "$extra")
        }
    }

    /**
     * Lets the next session of a student have the exam.
     *
     * @param by who does it, for the audit
     */
    fun release(
        exam: Exam,
        student: String,
        by: String,
    ) {
        database.write { handle ->
            seat(handle, exam, student)
            update(handle, exam, student, "session_hash = :value", null)
            note(handle, exam, student, by, ExamEventKind.RELEASED, "")
        }
    }

    /**
     * Deletes an exam that nobody has begun, so that its exercises are as those of others.
     *
     * @param by who does it, for the audit
     * @throws Rejection.BadExam where somebody has
     */
    fun drop(
        id: String,
        by: String,
    ): Exam =
        database.write { handle ->
            val exam = find(handle, id) ?: throw Rejection.UnknownExam(id)
            val begun = begun(handle, id)
            if (begun > 0) throw Rejection.BadExam("begun", begun)
            for (table in listOf("exam_events", "exam_drafts", "exam_sittings", "exam_exercises")) {
                handle.createUpdate("DELETE FROM $table WHERE exam_id = :exam").bind("exam", id).execute()
            }
            handle.createUpdate("DELETE FROM exams WHERE id = :exam").bind("exam", id).execute()
            audit(handle, exam, by, "exam-drop", exam.name)
            exam
        }

    /** How many students have begun an exam. */
    private fun begun(
        handle: Handle,
        exam: String,
    ): Int =
        handle
            .createQuery("SELECT count(*) FROM exam_sittings WHERE exam_id = :exam AND started_at IS NOT NULL")
            .bind("exam", exam)
            .mapTo(Int::class.javaObjectType)
            .one()

    private fun note(
        handle: Handle,
        exam: Exam,
        student: String,
        by: String,
        kind: ExamEventKind,
        detail: String,
    ) {
        ExamEvents.note(handle, exam.id, student, clock.instant(), kind, detail = detail)
        audit(handle, exam, by, "exam-${kind.code}", "$student $detail".trim())
    }

    private fun audit(
        handle: Handle,
        exam: Exam,
        by: String,
        action: String,
        detail: String,
    ) = AuditNote(by, exam.course, action, exam.id, detail).write(handle, clock.instant())

    private fun update(
        handle: Handle,
        exam: Exam,
        student: String,
        change: String,
        value: Any?,
    ) {
        handle
            .createUpdate("UPDATE exam_sittings SET $change WHERE exam_id = :exam AND student_id = :student")
            .bind("value", value)
            .bind("exam", exam.id)
            .bind("student", student)
            .execute()
    }

    internal companion object {
        /** Sees that a student of the exam's course has a row there. */
        fun seat(
            handle: Handle,
            exam: Exam,
            student: String,
        ) {
            val seated =
                handle
                    .createUpdate(
                        """INSERT INTO exam_sittings (exam_id, student_id)
                           SELECT :exam, id FROM students WHERE id = :student AND course_id = :course
                           ON CONFLICT (exam_id, student_id) DO UPDATE SET extra = exam_sittings.extra""",
                    ).bind("exam", exam.id)
                    .bind("student", student)
                    .bind("course", exam.course)
                    .execute()
            if (seated == 0) throw Rejection.UnknownStudent(student)
        }

        fun find(
            handle: Handle,
            id: String,
        ): Exam? =
            handle
                .createQuery("SELECT * FROM exams WHERE id = :id")
                .bind("id", id)
                .map { row, _ -> exam(handle, row) }
                .findOne()
                .getOrNull()

        fun ofCourse(
            handle: Handle,
            course: String,
        ): List<Exam> =
            handle
                .createQuery("SELECT * FROM exams WHERE course_id = :course ORDER BY opens_at, id")
                .bind("course", course)
                .map { row, _ -> exam(handle, row) }
                .list()

        fun sitting(
            handle: Handle,
            exam: Exam,
            student: String,
        ): Sitting =
            handle
                .createQuery("SELECT * FROM exam_sittings WHERE exam_id = :exam AND student_id = :student")
                .bind("exam", exam.id)
                .bind("student", student)
                .map { row, _ -> sitting(exam, student, row) }
                .findOne()
                .getOrNull() ?: Sitting(exam, student, 0, null, null, null, null)

        /** The exercises of a course that are kept for exams which are not over for everybody. */
        fun closed(
            handle: Handle,
            course: String,
            now: Instant,
        ): Set<String> = closed(handle, ofCourse(handle, course), now)

        private fun closed(
            handle: Handle,
            exams: List<Exam>,
            now: Instant,
        ): Set<String> =
            exams
                .filter { now <= it.over(mostExtra(handle, it)) }
                .flatMap { it.exercises }
                .toSet()

        private fun mostExtra(
            handle: Handle,
            exam: Exam,
        ): Int =
            handle
                .createQuery("SELECT coalesce(max(extra), 0) FROM exam_sittings WHERE exam_id = :exam")
                .bind("exam", exam.id)
                .mapTo(Int::class.javaObjectType)
                .one()

        private fun exam(
            handle: Handle,
            row: ResultSet,
        ): Exam {
            val id = row.getString("id")
            val exercises =
                handle
                    .createQuery("SELECT exercise FROM exam_exercises WHERE exam_id = :exam ORDER BY position")
                    .bind("exam", id)
                    .mapTo(String::class.java)
                    .list()
            return Exam(
                id,
                row.getString("course_id"),
                row.getString("name"),
                exercises,
                Instant.parse(row.getString("opens_at")),
                Instant.parse(row.getString("closes_at")),
                ZoneId.of(row.getString("zone")),
                row.getInt("minutes"),
                row.getInt("is_fixed") == 1,
                row.getInt("grace"),
                AddressList.of(row.getString("addresses")),
                row.getInt("takes_over") == 1,
            )
        }

        private fun sitting(
            exam: Exam,
            student: String,
            row: ResultSet,
        ) = Sitting(
            exam,
            student,
            row.getInt("extra"),
            row.getString("started_at")?.let(Instant::parse),
            row.getString("ended_at")?.let(Instant::parse),
            row.getString("session_hash"),
            row.getString("address"),
        )
    }
}
