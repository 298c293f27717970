// What is kept about one student: given out whole, or deleted for good. Start with StudentRecords.
package rasterlab.grader.student

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import java.sql.ResultSet
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/** Gives out, and deletes, what is kept about one student. Tokens are kept as hashes only, and are not given out. */
class StudentRecords(
    private val database: Database,
    private val clock: InstantSource,
) {
    /**
     * Reads everything that is kept.
     *
     * @param by who asks, for the audit
     * @throws Rejection.UnknownStudent
     */
    fun export(
        student: String,
        by: String,
    ): KeptStudent =
        database.write { handle ->
            val kept = read(handle, student)
            note(handle, student, by, "export", kept)
            kept
        }

    /** The student's record for a page, without a note of it. */
    fun look(student: String): KeptStudent = database.read { read(it, student) }

    /**
     * Deletes the student and all that belongs to them; the audit keeps the id, which names nobody then.
     *
     * @return what was deleted
     */
    fun delete(
        student: String,
        by: String,
    ): KeptStudent =
        database.write { handle ->
            val kept = read(handle, student)
            note(handle, student, by, "delete", kept)
            for (statement in DELETIONS) handle.createUpdate(statement).bind("student", student).execute()
            kept
        }

    private fun note(
        handle: Handle,
        student: String,
        by: String,
        action: String,
        kept: KeptStudent,
    ) {
        val detail = "number ${kept.number}, submissions ${kept.submissions.size}"
        AuditNote(by, kept.course, action, student, detail).write(handle, clock.instant())
    }

    private fun read(
        handle: Handle,
        student: String,
    ): KeptStudent {
        val results =
            handle
                .rows(
                    """SELECT r.* FROM results r JOIN submissions s ON s.id = r.submission_id $OWN
                       AND NOT EXISTS (SELECT 1 FROM trials WHERE result_id = r.id) ORDER BY run""",
                    student,
                ) { it.getString("submission_id") to result(it) }
                .groupBy({ it.first }, { it.second })
        val points =
            handle
                .rows(
                    "SELECT a.* FROM adjustments a JOIN submissions s ON s.id = a.submission_id $OWN ORDER BY given_at",
                    student,
                ) { it.getString("submission_id") to points(it) }
                .groupBy({ it.first }, { it.second })
        return handle
            .rows(
                """SELECT students.*, courses.name AS course_name FROM students JOIN courses ON courses.id = course_id
                   WHERE students.id = :student""",
                student,
            ) { row ->
                KeptStudent(
                    student,
                    row.getString("course_id"),
                    row.getString("course_name"),
                    row.getInt("number"),
                    row.getString("name"),
                    row.getString("shown_name"),
                    row.getString("joined_at"),
                    row.getInt("named_on_front") == 1,
                    emptyMap(),
                    emptyList(),
                    emptyList(),
                    emptyList(),
                    emptyList(),
                )
            }.singleOrNull()
            ?.copy(
                roster = handle.of("roster_fields", "kind", student, ::field).toMap(),
                extensions = handle.of("extensions", "exercise", student, ::extension),
                hints = handle.of("hints", "taken_at", student, ::hint),
                submissions = handle.of("submissions", "sequence", student) { submission(it, results, points) },
                comments = handle.rows("$SAID $OWN ORDER BY c.written_at, c.id", student, ::comment),
                complaints =
                    handle.rows(
                        "SELECT c.* FROM complaints c JOIN submissions s ON s.id = c.submission_id $OWN ORDER BY opened_at, c.id",
                        student,
                        ::complaint,
                    ),
                drafts = handle.of("exam_drafts", "exam_id, exercise", student, ::draft),
                examEvents = handle.of("exam_events", "exam_id, number", student, ::examEvent),
                platforms = handle.rows(PLATFORMS, student, ::platform),
                scores = handle.rows(SCORES, student, ::score),
            ) ?: throw Rejection.UnknownStudent(student)
    }

    private fun <T> Handle.of(
        table: String,
        order: String,
        student: String,
        read: (ResultSet) -> T,
    ): List<T> = rows("SELECT * FROM $table WHERE student_id = :student ORDER BY $order", student, read)

    private fun <T> Handle.rows(
        sql: String,
        student: String,
        read: (ResultSet) -> T,
    ): List<T> =
        createQuery(sql)
            .bind("student", student)
            .map { row, _ -> listOf(read(row)) }
            .list()
            .flatten()

    private fun field(row: ResultSet) = row.getString("kind") to row.getString("value")

    private fun extension(row: ResultSet) =
        KeptExtension(row.getString("exercise"), row.getString("due_at"), row.getString("reason"))

    private fun hint(row: ResultSet) =
        KeptHint(row.getString("exercise"), row.getInt("step"), row.getInt("cost"), row.getString("taken_at"))

    private fun comment(row: ResultSet) =
        KeptComment(
            row.getString("id"),
            row.getString("submission_id"),
            row.getString("thread_id"),
            row.getInt("line").takeUnless { row.wasNull() },
            row.getInt("last_line").takeUnless { row.wasNull() },
            row.getString("author_name").orEmpty(),
            row.getString("text"),
            row.getString("written_at"),
            row.getString("edited_at"),
        )

    private fun complaint(row: ResultSet) =
        KeptComplaint(
            row.getString("submission_id"),
            row.getString("case_name"),
            row.getString("text"),
            row.getString("opened_at"),
            row.getString("state"),
            row.getString("answer"),
            row.getString("answered_at"),
        )

    private fun draft(row: ResultSet) =
        KeptDraft(
            row.getString("exam_id"),
            row.getString("exercise"),
            row.getString("saved_at"),
            row.getString("source"),
        )

    private fun examEvent(row: ResultSet) =
        KeptExamEvent(
            row.getString("exam_id"),
            row.getString("noted_at"),
            row.getString("kind"),
            row.getString("address"),
            row.getString("detail"),
        )

    private fun platform(row: ResultSet) =
        KeptPlatform(row.getString("issuer"), row.getString("client_id"), row.getString("subject"))

    private fun score(row: ResultSet) =
        KeptScore(
            row.getString("issuer"),
            row.getString("exercise"),
            row.getInt("points").takeUnless { row.wasNull() },
            row.getInt("points_of"),
            row.getInt("sent_points").takeUnless { row.wasNull() },
            row.getString("sent_at"),
        )

    private fun result(row: ResultSet) =
        KeptResult(
            row.getInt("run"),
            row.getInt("is_current") == 1,
            row.getString("revision"),
            row.getString("verdict"),
            row.getInt("accuracy"),
            row.getInt("stability"),
            row.getInt("speed"),
            row.getInt("points_of"),
            row.getString("graded_at"),
        )

    private fun submission(
        row: ResultSet,
        results: Map<String, List<KeptResult>>,
        points: Map<String, List<KeptPoints>>,
    ) = KeptSubmission(
        row.getString("id"),
        row.getString("exercise"),
        row.getString("revision"),
        row.getInt("attempt"),
        row.getString("received_at"),
        row.getString("due_at"),
        row.getInt("hint_cost"),
        row.getInt("is_chosen") == 1,
        row.getString("source"),
        results[row.getString("id")].orEmpty(),
        points[row.getString("id")].orEmpty(),
    )

    private fun points(row: ResultSet) =
        KeptPoints(
            row.getInt("points"),
            row.getString("reason"),
            row.getString("given_at"),
            row.getString("revoked_at"),
        )

    private companion object {
        const val OWN = "WHERE s.student_id = :student"
        const val THEIRS = "SELECT id FROM submissions WHERE student_id = :student"
        const val RUNS = "SELECT id FROM results WHERE submission_id IN ($THEIRS)"

        const val SAID =
            """SELECT c.*, coalesce(students.shown_name, instructors.name) AS author_name FROM comments c
               JOIN submissions s ON s.id = c.submission_id
               LEFT JOIN students ON students.id = c.author_id LEFT JOIN instructors ON instructors.id = c.author_id"""

        const val PLATFORMS =
            """SELECT issuer, client_id, subject, told_name FROM lti_students JOIN lti_platforms ON lti_platforms.id = platform_id
               WHERE student_id = :student ORDER BY issuer, subject"""

        const val SCORES =
            """SELECT s.*, issuer FROM lti_scores s JOIN lti_links ON lti_links.id = s.link_id
               JOIN lti_platforms ON lti_platforms.id = platform_id
               WHERE student_id = :student ORDER BY s.exercise, s.link_id"""

        /**
         * The requests that made the student, or rosters with them; their submissions, what was said about these, and
         * their hints. Rosters are kept as JSON, in which ids stand in quotes; `LIKE` would take their `_` for anything.
         */
        const val MADE =
            """made = :student OR made IN ($THEIRS) OR owner = 'hints ' || :student
               OR made IN (SELECT id FROM comments WHERE submission_id IN ($THEIRS))
               OR made IN (SELECT id FROM complaints WHERE submission_id IN ($THEIRS))
               OR made IN (SELECT id FROM trials WHERE submission_id IN ($THEIRS))
               OR (owner LIKE 'roster %' AND made <> replace(made, '"' || :student || '"', ''))"""

        /** The tables of what a student did at exams. */
        val EXAMS = listOf("exam_events", "exam_drafts", "exam_sittings")

        /** Deletes what refers to something before that. */
        val DELETIONS =
            listOf(
                "DELETE FROM regrade_items WHERE submission_id IN ($THEIRS)",
                "DELETE FROM idempotency_keys WHERE $MADE",
                "DELETE FROM complaints WHERE submission_id IN ($THEIRS)",
                "DELETE FROM trials WHERE submission_id IN ($THEIRS)",
            ) +
                listOf("case_pictures", "case_results", "diagnostics", "speed_methods").map {
                    "DELETE FROM $it WHERE result_id IN ($RUNS)"
                } +
                listOf(
                    "results",
                    "comments",
                    "adjustments",
                ).map { "DELETE FROM $it WHERE submission_id IN ($THEIRS)" } +
                EXAMS.map { "DELETE FROM $it WHERE student_id = :student" } +
                listOf("submissions", "hints", "extensions", "roster_fields", "lti_scores", "lti_students").map {
                    "DELETE FROM $it WHERE student_id = :student"
                } +
                "DELETE FROM sessions WHERE account_id = :student" +
                "DELETE FROM students WHERE id = :student"
    }
}
