package rasterlab.grader.exam

import org.jdbi.v3.core.Handle
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Intake
import rasterlab.grader.submission.SheetDraft
import rasterlab.grader.submission.Submission
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * Who works on an exam, and from where.
 *
 * @param session a secret that only this browser or program has
 * @param address in digits
 */
class Examinee(
    val student: Identity.StudentIdentity,
    val session: String,
    val address: String,
)

/**
 * A text that a student wrote.
 *
 * @param handed whether just this is handed in
 */
class Draft(
    val source: String,
    val saved: Instant,
    val handed: Boolean,
)

/**
 * Lets students work at exams. All times are of a clock that moves by nothing but the passing of time.
 *
 * @param handedIn told the id of each submission that is made
 */
class Sittings(
    private val database: Database,
    private val exercises: Exercises,
    private val intake: Intake,
    private val clock: InstantSource,
    private val handedIn: (String) -> Unit,
) {
    fun now(): Instant = clock.instant()

    /** The exams of a student's course, each as it stands with them. */
    fun of(student: Identity.StudentIdentity): List<Sitting> =
        database.read { handle ->
            Exams.ofCourse(handle, student.course).map { Exams.sitting(handle, it, student.id) }
        }

    /** The exam that a student has now, and nothing beside; null where there is none. */
    fun holding(student: Identity.StudentIdentity): Sitting? = of(student).firstOrNull { it.holds(now()) }

    /** Whether a submission was handed in at that exam by that student, not before it. */
    fun hold(
        sitting: Sitting,
        submission: Submission,
    ): Boolean = database.read { ExamEvents.tell(it, sitting, handIn(submission.exercise, submission.id)) }

    /** The exercises that a student does not get now, since they are kept for exams. */
    fun closedTo(who: Identity): Set<String> =
        if (who is Identity.StudentIdentity) database.read { Exams.closed(it, who.course, now()) } else emptySet()

    /** Begins the exam, or goes on with it in another session where that may be. */
    fun open(
        exam: String,
        examinee: Examinee,
    ): Sitting =
        attempt { handle, now ->
            val sitting = sitting(handle, exam, examinee)
            val refusal = entrance(handle, sitting, examinee, now, opens = true)
            if (refusal != null) return@attempt Result.failure(refusal)
            Exams.seat(handle, sitting.exam, sitting.student)
            handle
                .createUpdate(
                    """UPDATE exam_sittings
                       SET started_at = coalesce(started_at, :now), session_hash = :session, address = :address
                       WHERE exam_id = :exam AND student_id = :student""",
                ).bind("now", now.text())
                .bind("session", Secrets.hash(examinee.session))
                .bind("address", examinee.address)
                .bind("exam", exam)
                .bind("student", sitting.student)
                .execute()
            if (sitting.started == null) note(handle, sitting, now, ExamEventKind.OPENED, examinee)
            Result.success(Exams.sitting(handle, sitting.exam, sitting.student))
        }

    /** Lets in who works on a running exam: the same session, from an address that is allowed. */
    fun enter(
        exam: String,
        examinee: Examinee,
    ): Sitting = attempt { handle, now -> entered(handle, exam, examinee, now) }

    /** The texts that the student wrote last, by exercise. */
    fun drafts(sitting: Sitting): Map<String, Draft> = database.read { drafts(it, sitting) }

    /** Keeps a text, so that it is there after a reload, in another browser, and when time is over. */
    fun keep(
        exam: String,
        exercise: String,
        source: String,
        examinee: Examinee,
    ): Sitting =
        attempt { handle, now ->
            entered(handle, exam, examinee, now).map { sitting ->
                requireIn(sitting, exercise)
                if (drafts(handle, sitting)[exercise]?.source != source) {
                    store(handle, sitting, exercise, source, now, handed = false)
                    note(handle, sitting, now, ExamEventKind.DRAFT, examinee, "$exercise ${source.length}")
                }
                sitting
            }
        }

    /**
     * Hands a text in.
     *
     * @param draft the text that the student has of it, which is kept
     * @return the id of the submission
     */
    fun handIn(
        exam: String,
        exercise: Exercise,
        source: String,
        key: String?,
        examinee: Examinee,
        draft: String = source,
    ): String {
        val sitting = keep(exam, exercise.id(), draft, examinee)
        val id = intake.acceptAtExam(sitting.student, exercise, source, key, limited = true)
        database.write { handle ->
            store(handle, sitting, exercise.id(), draft, now(), handed = true)
            // A form that is sent twice hands in once.
            val handed = handIn(exercise.id(), id)
            if (!ExamEvents.tell(handle, sitting, handed)) {
                note(handle, sitting, now(), ExamEventKind.HAND_IN, examinee, handed)
            }
        }
        handedIn(id)
        return id
    }

    /** Ends the exam of a student before time is over; their last texts are handed in. */
    fun end(
        exam: String,
        examinee: Examinee,
    ) = finish(enter(exam, examinee), examinee.address)

    /** Ends the exams whose time is over, and hands in the last texts of those who worked on them. */
    fun settle() {
        val now = now()
        val over =
            database.read { handle ->
                handle
                    .createQuery(
                        """SELECT exam_id, student_id FROM exam_sittings
                           WHERE started_at IS NOT NULL AND ended_at IS NULL""",
                    ).map { row, _ -> row.getString("exam_id") to row.getString("student_id") }
                    .list()
                    .mapNotNull { (exam, student) ->
                        Exams.find(handle, exam)?.let { Exams.sitting(handle, it, student) }
                    }.filter { it.state(now) == SittingState.OVER }
            }
        over.forEach { finish(it, address = "") }
    }

    /** Hands in what was not yet; a repetition after a fault hands in nothing twice, since it has the same key. */
    private fun finish(
        sitting: Sitting,
        address: String,
    ) {
        for ((exercise, draft) in drafts(sitting).filter { !it.value.handed && it.value.source.isNotBlank() }) {
            val (kind, detail) = handLast(sitting, exercise, draft)
            database.write { handle ->
                store(handle, sitting, exercise, draft.source, draft.saved, handed = true)
                ExamEvents.note(handle, sitting.exam.id, sitting.student, now(), kind, address, "$exercise $detail")
            }
        }
        database.write { handle ->
            val ended =
                handle
                    .createUpdate(
                        """UPDATE exam_sittings SET ended_at = :now
                           WHERE exam_id = :exam AND student_id = :student AND ended_at IS NULL""",
                    ).bind("now", now().text())
                    .bind("exam", sitting.exam.id)
                    .bind("student", sitting.student)
                    .execute()
            if (ended == 1) ExamEvents.note(handle, sitting.exam.id, sitting.student, now(), ExamEventKind.END, address)
        }
    }

    private fun handLast(
        sitting: Sitting,
        exercise: String,
        draft: Draft,
    ): Pair<ExamEventKind, String> =
        try {
            val key = "exam ${sitting.exam.id} ${Secrets.hash(draft.source)}"
            val named = exercises.named(exercise)
            val source = SheetDraft.document(named, draft.source)
            val id = intake.acceptAtExam(sitting.student, named, source, key, limited = false)
            handedIn(id)
            ExamEventKind.HAND_IN to id
        } catch (refusal: Rejection) {
            if (refusal is Rejection.NoRoom) throw refusal
            ExamEventKind.NOT_TAKEN to refusal.code
        }

    private fun entered(
        handle: Handle,
        exam: String,
        examinee: Examinee,
        now: Instant,
    ): Result<Sitting> {
        val sitting = sitting(handle, exam, examinee)
        if (sitting.started == null) return Result.failure(Rejection.ExamNotOpen(sitting.exam.name))
        val refusal = entrance(handle, sitting, examinee, now)
        if (refusal == null && sitting.session == null) return Result.failure(Rejection.OtherSession())
        if (refusal != null) return Result.failure(refusal)
        if (sitting.address != examinee.address) {
            handle
                .createUpdate(
                    "UPDATE exam_sittings SET address = :address WHERE exam_id = :exam AND student_id = :student",
                ).bind("address", examinee.address)
                .bind("exam", exam)
                .bind("student", sitting.student)
                .execute()
            note(handle, sitting, now, ExamEventKind.ADDRESS, examinee, sitting.address.orEmpty())
        }
        return Result.success(sitting)
    }

    /**
     * Tells why somebody is not let in now; null where they are.
     *
     * @param opens whether they open the exam, and may so end another session
     */
    private fun entrance(
        handle: Handle,
        sitting: Sitting,
        examinee: Examinee,
        now: Instant,
        opens: Boolean = false,
    ): Rejection? {
        val exam = sitting.exam
        val other = sitting.session != null && sitting.session != Secrets.hash(examinee.session)
        return when {
            sitting.state(now) == SittingState.OVER -> {
                Rejection.ExamOver(exam.name)
            }

            sitting.state(now) == SittingState.WAITING -> {
                Rejection.ExamNotOpen(exam.name)
            }

            !exam.addresses.allows(examinee.address) -> {
                note(handle, sitting, now, ExamEventKind.ADDRESS_REFUSED, examinee)
                Rejection.ExamAddress(examinee.address)
            }

            other && opens && exam.takesOver -> {
                note(handle, sitting, now, ExamEventKind.SESSION_TAKEN_OVER, examinee)
                null
            }

            other -> {
                note(handle, sitting, now, ExamEventKind.SECOND_SESSION, examinee)
                Rejection.OtherSession()
            }

            else -> {
                null
            }
        }
    }

    /** An event that was noted stays, though the request that it was noted of is refused. */
    private fun attempt(work: (Handle, Instant) -> Result<Sitting>): Sitting =
        database.write { work(it, now()) }.getOrThrow()

    private fun sitting(
        handle: Handle,
        exam: String,
        examinee: Examinee,
    ): Sitting {
        val found = Exams.find(handle, exam)?.takeIf { it.course == examinee.student.course }
        return Exams.sitting(handle, found ?: throw Rejection.UnknownExam(exam), examinee.student.id)
    }

    private fun requireIn(
        sitting: Sitting,
        exercise: String,
    ) {
        if (exercise !in sitting.exam.exercises) throw Rejection.UnknownExercise(exercise)
    }

    private fun drafts(
        handle: Handle,
        sitting: Sitting,
    ): Map<String, Draft> =
        handle
            .createQuery("SELECT * FROM exam_drafts WHERE exam_id = :exam AND student_id = :student")
            .bind("exam", sitting.exam.id)
            .bind("student", sitting.student)
            .map { row, _ ->
                row.getString("exercise") to
                    Draft(
                        row.getString("source"),
                        Instant.parse(row.getString("saved_at")),
                        row.getInt("is_handed") == 1,
                    )
            }.list()
            .toMap()

    private fun store(
        handle: Handle,
        sitting: Sitting,
        exercise: String,
        source: String,
        at: Instant,
        handed: Boolean,
    ) {
        handle
            .createUpdate(
                """INSERT INTO exam_drafts (exam_id, student_id, exercise, source, saved_at, is_handed)
                   VALUES (:exam, :student, :exercise, :source, :at, :handed)
                   ON CONFLICT (exam_id, student_id, exercise)
                   DO UPDATE SET source = excluded.source, saved_at = excluded.saved_at,
                       is_handed = excluded.is_handed""",
            ).bind("exam", sitting.exam.id)
            .bind("student", sitting.student)
            .bind("exercise", exercise)
            .bind("source", source)
            .bind("at", at.text())
            .bind("handed", if (handed) 1 else 0)
            .execute()
    }

    /** The detail of a hand-in, which names the submission. */
    private fun handIn(
        exercise: String,
        submission: String,
    ) = "$exercise $submission"

    private fun note(
        handle: Handle,
        sitting: Sitting,
        now: Instant,
        kind: ExamEventKind,
        examinee: Examinee,
        detail: String = "",
    ) = ExamEvents.note(handle, sitting.exam.id, sitting.student, now, kind, examinee.address, detail)
}
