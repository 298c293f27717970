package rasterlab.grader.similarity

import org.jdbi.v3.core.Handle
import rasterlab.exercises.Exercise
import rasterlab.grader.storage.Database
import java.sql.ResultSet
import java.time.Instant
import kotlin.jvm.optionals.getOrNull

/**
 * A program with what a person wants to know of it.
 *
 * @param name of the student as it is shown
 * @param course its name: programs of earlier years are compared too
 */
data class HandedProgram(
    val submission: String,
    val exercise: String,
    val student: String,
    val name: String,
    val course: String,
    val receivedAt: Instant,
    val source: String,
)

/**
 * Two of them.
 *
 * @param sameWrong the cases, by name, that both got wrong in the same way
 */
data class Likeness(
    val first: HandedProgram,
    val second: HandedProgram,
    val pair: AlikePair,
    val sameWrong: List<String>,
)

/**
 * All that is alike for an exercise.
 *
 * @param leftOut that have nothing to compare: no Java, or no more than the starter
 */
data class LikenessReport(
    val programs: Int,
    val pairs: List<Likeness>,
    val leftOut: List<HandedProgram>,
)

/**
 * Finds programs that are alike, of all courses on this server. It accuses nobody: it shows a person where to look.
 *
 * Compared is what each student handed in last; what does not compile is not.
 */
class Similar(
    private val database: Database,
) {
    /**
     * Compares the programs of one course, or of all.
     *
     * @param exercise that students write programs for
     * @param course its id; null for all of the server
     */
    fun of(
        exercise: Exercise,
        course: String? = null,
    ): LikenessReport {
        val handed = last(exercise.id(), course).associateBy { it.submission }
        val alike =
            SimilarityFinder(handed.values.map { Program(it.submission, it.student, it.source) }, exercise.starter())
        val pairs = alike.pairs(MOST)
        return LikenessReport(
            handed.size,
            pairs.map { likeness(handed.getValue(it.first.id), handed.getValue(it.second.id), it) },
            alike.leftOut.map { handed.getValue(it.id) },
        )
    }

    /** The last program of each student of a course, or of all, in the order in which they came. */
    fun last(
        exercise: String,
        course: String? = null,
    ): List<HandedProgram> =
        database
            .read { handle ->
                handle
                    .createQuery(
                        """$HANDED WHERE s.exercise = :exercise AND r.verdict NOT IN $NO_PROGRAM
                           AND students.course_id = coalesce(:course, students.course_id) ORDER BY s.sequence""",
                    ).bind("exercise", exercise)
                    .bind("course", course)
                    .map { row, _ -> handed(row) }
                    .list()
            }.associateBy { it.student }
            .values
            .toList()

    /** A submission of a course, or of any, that is graded, as it was handed in; null where there is none. */
    fun find(
        submission: String,
        course: String? = null,
    ): HandedProgram? =
        database.read { handle ->
            handle
                .createQuery("$HANDED WHERE s.id = :id AND students.course_id = coalesce(:course, students.course_id)")
                .bind("id", submission)
                .bind("course", course)
                .map { row, _ -> handed(row) }
                .findOne()
                .getOrNull()
        }

    /** The cases that both got wrong with the same answer, as far as the verdict's words and the picture tell. */
    fun sameWrong(
        first: String,
        second: String,
    ): List<String> = database.read { sameWrong(it, first, second) }

    private fun likeness(
        first: HandedProgram,
        second: HandedProgram,
        pair: AlikePair,
    ) = Likeness(first, second, pair, sameWrong(first.submission, second.submission))

    private fun sameWrong(
        handle: Handle,
        first: String,
        second: String,
    ): List<String> =
        handle
            .createQuery(
                """SELECT mine.name
                   FROM results AS ours JOIN case_results AS mine ON mine.result_id = ours.id
                   JOIN results AS theirs ON theirs.submission_id = :second AND theirs.is_current = 1
                   JOIN case_results AS other ON other.result_id = theirs.id AND other.name = mine.name
                   LEFT JOIN case_pictures AS drawn
                       ON drawn.result_id = ours.id AND drawn.case_position = mine.position AND drawn.kind = 'actual'
                   LEFT JOIN case_pictures AS drawn_too
                       ON drawn_too.result_id = theirs.id AND drawn_too.case_position = other.position
                       AND drawn_too.kind = 'actual'
                   WHERE ours.submission_id = :first AND ours.is_current = 1
                       AND mine.verdict = 'WRONG' AND other.verdict = 'WRONG'
                       AND mine.message = other.message AND mine.message_data = other.message_data
                       AND (drawn.png = drawn_too.png OR (drawn.png IS NULL AND drawn_too.png IS NULL))
                   ORDER BY mine.position""",
            ).bind("first", first)
            .bind("second", second)
            .mapTo(String::class.java)
            .list()

    private fun handed(row: ResultSet) =
        HandedProgram(
            row.getString("id"),
            row.getString("exercise"),
            row.getString("student_id"),
            row.getString("student_name"),
            row.getString("course_name"),
            Instant.parse(row.getString("received_at")),
            row.getString("source"),
        )

    private companion object {
        /** More pairs than a person looks through. */
        const val MOST = 100

        /** Verdicts of what never was a program that ran. */
        const val NO_PROGRAM = "('compile_error', 'internal')"

        const val HANDED = """SELECT s.id, s.exercise, s.student_id, s.source, s.received_at, students.shown_name AS student_name,
                                  courses.name AS course_name
                              FROM submissions s
                              JOIN students ON students.id = s.student_id
                              JOIN courses ON courses.id = students.course_id
                              JOIN results r ON r.submission_id = s.id AND r.is_current = 1"""
    }
}
