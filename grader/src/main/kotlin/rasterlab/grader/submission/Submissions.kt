package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.StudentStanding
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.storage.Database
import java.sql.ResultSet
import java.time.Instant
import kotlin.jvm.optionals.getOrNull

/**
 * One line of a list of submissions.
 *
 * @param revision of the exercise that it was or will be graded against
 * @param late whether it was handed in after the deadline, that of now and the one that held then
 * @param chosen whether the student said that it counts
 * @param given points that staff gave beside those of grading, negative where they took them
 */
data class Listed(
    val submission: Submission,
    val student: String,
    val verdict: String?,
    val points: Int?,
    val of: Int?,
    val revision: String,
    val late: Boolean,
    val chosen: Boolean,
    val given: Int,
)

/** Reads submissions. */
class Submissions(
    private val database: Database,
) {
    fun find(id: String): Submission? = database.read { find(it, id) }

    /** @throws Rejection.UnknownSubmission for one that does not exist or is not for these eyes */
    fun seenBy(
        who: Identity,
        id: String,
    ): Submission {
        val found = find(id)
        if (found == null || !isFor(who, found)) throw Rejection.UnknownSubmission(id)
        return found
    }

    private fun isFor(
        who: Identity,
        found: Submission,
    ): Boolean =
        when (who) {
            is Identity.StudentIdentity -> found.student == who.id
            is Identity.StaffIdentity -> who.onlyCourse == null || courseOf(found.student) == who.onlyCourse
        }

    private fun courseOf(student: String): String =
        database.read { handle ->
            handle
                .createQuery("SELECT course_id FROM students WHERE id = :student")
                .bind("student", student)
                .mapTo(String::class.java)
                .one()
        }

    /** Where it stands in the queue. */
    fun place(id: String): QueuePlace = QueuePlace.of(database, id)

    fun waiting(): Int =
        database.read {
            it
                .createQuery("SELECT count(*) FROM submissions WHERE state = 'queued'")
                .mapTo(Int::class.javaObjectType)
                .one()
        }

    /** How many there are in each state, and how many are graded again: whenever anything moves, this differs. */
    fun counts(): List<String> =
        database.read {
            it
                .createQuery(
                    """SELECT state || ' ' || count(*) AS counted FROM submissions GROUP BY state
                       UNION ALL SELECT 'again ' || state || ' ' || count(*) FROM regrade_items GROUP BY state
                       UNION ALL SELECT 'trial ' || state || ' ' || count(*) FROM trials GROUP BY state
                       ORDER BY counted""",
                ).mapTo(String::class.java)
                .list()
        }

    fun ofStudent(
        student: String,
        exercise: String,
    ): List<Listed> =
        list(
            "WHERE s.student_id = :student AND s.exercise = :exercise",
            mapOf(
                "student" to student,
                "exercise" to exercise,
            ),
        )

    /** The bests of a student; null for an instructor, who hands nothing in. */
    fun bestsOf(who: Identity): Map<String, Int?>? = if (who is Identity.StudentIdentity) bests(who.id) else null

    /**
     * The most points of what the student has handed in, by exercise; null as long as nothing is
     * graded.
     */
    fun bests(student: String): Map<String, Int?> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT s.exercise, max($NET) AS best
                       FROM submissions s LEFT JOIN results r ON r.submission_id = s.id AND r.is_current = 1
                       WHERE s.student_id = :student GROUP BY s.exercise""",
                ).bind("student", student)
                .map { row, _ -> row.getString("exercise") to row.getInt("best").takeUnless { row.wasNull() } }
                .list()
                .toMap()
        }

    /** How far a student has come; null for an instructor, who hands nothing in. */
    fun standingOf(who: Identity): StudentStanding? =
        if (who is Identity.StudentIdentity) StudentStanding(bests(who.id), attempts(who.id)) else null

    private fun attempts(student: String): Map<String, Int> =
        database.read { handle ->
            handle
                .createQuery(
                    "SELECT exercise, count(*) AS made FROM submissions WHERE student_id = :student GROUP BY exercise",
                ).bind("student", student)
                .map { row, _ -> row.getString("exercise") to row.getInt("made") }
                .list()
                .toMap()
        }

    /** The one line about that submission, or null if there is none. */
    fun listed(id: String): Listed? = list("WHERE s.id = :id", mapOf("id" to id)).singleOrNull()

    fun latest(who: Identity.StaffIdentity): List<Listed> =
        who.onlyCourse?.let { list("WHERE students.course_id = :course", mapOf("course" to it)) }
            ?: list("", emptyMap())

    /** The latest of a student, of all exercises. */
    fun allOf(student: String): List<Listed> = list("WHERE s.student_id = :student", mapOf("student" to student))

    /** How much each student of a course has handed in, by the student's id. */
    fun countsOf(course: String): Map<String, Int> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT student_id, count(*) AS made FROM submissions JOIN students ON students.id = student_id
                       WHERE course_id = :course GROUP BY student_id""",
                ).bind("course", course)
                .map { row, _ -> row.getString("student_id") to row.getInt("made") }
                .list()
                .toMap()
        }

    /**
     * Lists those of a course, the latest first.
     *
     * @param exercise the only one that is asked for; null for all
     * @param student the only one who is asked for; null for all
     */
    fun ofCourse(
        course: String,
        exercise: String?,
        student: String?,
        paging: Paging,
    ): ListPart<Listed> {
        val last =
            paging.after?.let { id ->
                find(id)?.takeIf { courseOf(it.student) == course }
                    ?: throw paging.unknown()
            }
        val asked =
            listOfNotNull(
                Triple("students.course_id = :course", "course", course),
                exercise?.let { Triple("s.exercise = :exercise", "exercise", it) },
                student?.let { Triple("s.student_id = :student", "student", it) },
                last?.let { Triple("s.sequence < (SELECT sequence FROM submissions WHERE id = :last)", "last", it.id) },
            )
        val condition = asked.joinToString(" AND ", prefix = "WHERE ") { it.first }
        return paging.cut(list(condition, asked.associate { it.second to it.third }, paging.reach)) { it.submission.id }
    }

    private fun list(
        condition: String,
        bindings: Map<String, Any>,
        most: Int = LISTED,
    ) = database.read { handle ->
        handle
            .createQuery(
                """SELECT s.id, s.student_id, s.exercise, s.revision, s.attempt, '' AS source, s.seed, s.received_at,
                          s.state, s.tries, s.hint_cost, s.penalty, s.is_chosen, s.due_at, students.shown_name AS student_name, r.verdict,
                          r.revision AS graded_against, $NET AS total, r.points_of,
                          $GIVEN AS given,
                          CASE WHEN s.received_at > ${ExerciseRules.DUE} AND s.received_at > s.due_at
                              THEN 1 ELSE 0 END AS late
                   FROM submissions s
                   JOIN students ON students.id = s.student_id
                   LEFT JOIN course_exercises AS rules
                       ON rules.course_id = students.course_id AND rules.exercise = s.exercise
                   LEFT JOIN extensions ON extensions.student_id = s.student_id AND extensions.exercise = s.exercise
                   LEFT JOIN results r ON r.submission_id = s.id AND r.is_current = 1
                   $condition ORDER BY s.sequence DESC LIMIT :most""",
            ).bindMap(bindings)
            .bind("most", most)
            .map { row, _ ->
                val verdict = row.getString("verdict")
                val graded = verdict != null
                Listed(
                    submission(row),
                    row.getString("student_name"),
                    verdict,
                    if (graded) row.getInt("total") else null,
                    if (graded) row.getInt("points_of") else null,
                    if (graded) row.getString("graded_against") else row.getString("revision"),
                    row.getInt("late") == 1,
                    row.getInt("is_chosen") == 1,
                    row.getInt("given"),
                )
            }.list()
    }

    companion object {
        private const val LISTED = 100

        /** The points that staff gave a submission, less those that they took. */
        internal const val GIVEN =
            """coalesce((SELECT sum(a.points) FROM adjustments a
               WHERE a.submission_id = s.id AND a.revoked_at IS NULL), 0)"""

        /** The points of the result in row `r` that are left beside hints and lateness, and what staff gave or took. */
        internal val NET =
            """(SELECT CASE WHEN graded + given > 0 THEN graded + given WHEN graded IS NOT NULL THEN 0 END
               FROM (SELECT $GIVEN AS given, ${graded("r")} AS graded) AS net)"""

        /**
         * The points of a result that are left when its submission in row `s` paid for hints, and then for lateness, whose
         * share is rounded down to whole points; null where there is no result.
         *
         * @param result the name of its row
         */
        internal fun graded(result: String): String {
            val sum = "$result.accuracy + $result.stability + $result.speed"
            return """(SELECT kept - kept * s.penalty / 100 FROM
                (SELECT CASE WHEN $sum > s.hint_cost THEN $sum - s.hint_cost WHEN $result.id IS NOT NULL THEN 0 END AS kept) AS beside)"""
        }

        internal fun find(
            handle: Handle,
            id: String,
        ): Submission? =
            handle
                .createQuery("SELECT * FROM submissions WHERE id = :id")
                .bind("id", id)
                .map { row, _ -> submission(row) }
                .findOne()
                .getOrNull()

        internal fun position(
            handle: Handle,
            id: String,
        ): Int =
            handle
                .createQuery(
                    """SELECT count(*) FROM submissions mine JOIN submissions other
                       ON other.state = 'queued' AND (other.round, other.sequence) <= (mine.round, mine.sequence)
                       WHERE mine.id = :id AND mine.state = 'queued'""",
                ).bind("id", id)
                .mapTo(Int::class.javaObjectType)
                .one()

        private fun submission(row: ResultSet) =
            Submission(
                id = row.getString("id"),
                student = row.getString("student_id"),
                exercise = row.getString("exercise"),
                revision = row.getString("revision"),
                attempt = row.getInt("attempt"),
                source = row.getString("source"),
                seed = row.getLong("seed"),
                receivedAt = Instant.parse(row.getString("received_at")),
                state = State.of(row.getString("state")),
                tries = row.getInt("tries"),
                hintCost = row.getInt("hint_cost"),
                penalty = row.getInt("penalty"),
                dueAt = row.getString("due_at")?.let { Instant.parse(it) },
            )
    }
}
