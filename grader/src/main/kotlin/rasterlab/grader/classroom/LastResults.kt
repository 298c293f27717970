/*
 * A class seen as a whole: which cases fail, and for whom.
 * Read LastResults, ErrorMap, DifferenceSum, then ErrorRoutes; everything here is for staff.
 */
package rasterlab.grader.classroom

import org.jdbi.v3.core.Handle
import rasterlab.exercises.score.CasePicture
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message
import rasterlab.exercises.score.PicturePart
import rasterlab.exercises.score.PixelRows
import rasterlab.grader.storage.Database
import rasterlab.grader.submission.Submission
import kotlin.jvm.optionals.getOrNull

/**
 * A student's result for one case.
 *
 * @param said why it failed; nothing where the verdict tells all
 * @param picture hash of the picture of the answer; empty where there is none
 * @param pixels whether its difference is a picture of pixels
 */
class CaseMark(
    val name: String,
    val visibility: Disclosure,
    val verdict: GradingVerdict,
    val said: Message,
    val picture: String,
    val pixels: Boolean,
) {
    val passed get() = verdict == GradingVerdict.OK

    /** The words on the answer, as data, without the sentences that explain all failures together. */
    internal val answer by lazy { Message(said.sentences.takeWhile { !it.key.startsWith("cause.") }).data() }
}

/**
 * The result that counts of the last submission that a student has graded.
 *
 * @param name of the student as it is shown
 * @param cases without the lines on speed and on points that are taken off; none where nothing ran
 * @param shared the mistake that the report tells to explain all that is wrong; nothing where it tells none
 */
data class LastResult(
    val student: String,
    val name: String,
    val submission: String,
    val attempt: Int,
    val verdict: String,
    val cases: List<CaseMark>,
    val shared: Message,
)

/** Rows of characters that show where an answer of the last results differs, and which pixels they are. */
class DrawnDifference(
    val rows: List<String>,
    val part: PicturePart,
)

/** Reads the last results of a class. */
class LastResults(
    private val database: Database,
) {
    private val known = KnownMarks()

    /** Reads those of a course for an exercise, in the order of the students' names. */
    fun of(
        course: String,
        exercise: String,
    ): List<LastResult> =
        database.read { handle ->
            val rows =
                handle
                    .last(
                        course,
                        exercise,
                        "students.id AS student, students.shown_name, last.id, last.attempt, last.result, last.verdict",
                        "JOIN students ON students.id = last.student_id",
                        "ORDER BY students.shown_name, students.number",
                    ).map { row, _ ->
                        val without =
                            LastResult(
                                row.getString("student"),
                                row.getString("shown_name"),
                                row.getString("id"),
                                row.getInt("attempt"),
                                row.getString("verdict"),
                                emptyList(),
                                Message.NONE,
                            )
                        row.getString("result") to without
                    }.list()
            val marks = known.of(handle, rows.map { it.first })
            rows.map { (result, one) -> marks.getValue(result).let { one.copy(cases = it.cases, shared = it.shared) } }
        }

    /** Reads the result of a submission that counts, in a transaction; null where none does. */
    internal fun of(
        handle: Handle,
        submission: Submission,
    ): LastResult? {
        val (result, verdict) =
            handle
                .createQuery(
                    """SELECT id, verdict FROM results
                       WHERE submission_id = :id AND is_current = 1 AND verdict <> 'internal'""",
                ).bind("id", submission.id)
                .map { row, _ -> row.getString("id") to row.getString("verdict") }
                .findOne()
                .getOrNull() ?: return null
        val marks = known.of(handle, listOf(result)).getValue(result)
        return LastResult(
            submission.student,
            "",
            submission.id,
            submission.attempt,
            verdict,
            marks.cases,
            marks.shared,
        )
    }

    /** The differences in pixels of one case. */
    fun differences(
        course: String,
        exercise: String,
        case: String,
    ): List<DrawnDifference> =
        database.read { handle ->
            handle
                .last(
                    course,
                    exercise,
                    "drawn.text, drawn.part",
                    """JOIN case_results AS judged ON judged.result_id = last.result AND judged.name = :case
                       JOIN case_pictures AS drawn ON drawn.result_id = last.result
                           AND drawn.case_position = judged.position AND drawn.kind = '${CasePicture.DIFFERENCE}'""",
                    "AND drawn.part IS NOT NULL",
                ).bind("case", case)
                .map { row, _ -> difference(row.getString("text"), row.getString("part")) }
                .list()
                .filterNotNull()
        }

    private fun difference(
        text: String,
        part: String,
    ): DrawnDifference? {
        val known = PicturePart.ofData(part).getOrNull() ?: return null
        return DrawnDifference(PixelRows.of(text, PicturePart.ofData(part)), known)
    }
}

/** A question about the last results, as the rows of `last`. */
internal fun Handle.last(
    course: String,
    exercise: String,
    columns: String,
    joined: String,
    more: String,
) = createQuery("$LAST SELECT $columns FROM last $joined WHERE back = 1 $more")
    .bind("course", course)
    .bind("exercise", exercise)

/** Selects them as the rows of `last` whose `back` is 1; what the server's own fault left is nobody's result. */
private const val LAST = """WITH last AS (
    SELECT s.id, s.student_id, s.attempt, r.id AS result, r.verdict,
        row_number() OVER (PARTITION BY s.student_id ORDER BY s.sequence DESC) AS back
    FROM students AS enrolled
    JOIN submissions AS s ON s.student_id = enrolled.id AND s.exercise = :exercise
    JOIN results AS r ON r.submission_id = s.id AND r.is_current = 1
    WHERE enrolled.course_id = :course AND r.verdict <> 'internal')"""
