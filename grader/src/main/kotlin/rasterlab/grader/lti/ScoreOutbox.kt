package rasterlab.grader.lti

import org.jdbi.v3.core.Handle
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Lease
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Marks
import java.sql.ResultSet
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * Points that are to be sent.
 *
 * @param subject what the platform calls the student
 * @param points null where there are none any more
 * @param version of the change
 * @param changedAt later for each version
 * @param lease of whoever sends them now
 */
internal class DueScore(
    val link: String,
    val student: String,
    val platform: String,
    val subject: String,
    val exercise: String,
    val points: Int?,
    val of: Int,
    val version: Int,
    val changedAt: String,
    val lease: String,
)

/**
 * Keeps what each student's points at each link are to be, and sees to it that every change is sent once: what is due
 * stays so until the platform has taken it, whatever process ends meanwhile.
 *
 * @param wall the clock that platforms are told
 * @param steady the clock of what is due after a while
 * @param holder the name of this server, which no other has that uses the database now
 */
internal class ScoreOutbox(
    private val database: Database,
    private val marks: Marks,
    private val exercises: Exercises,
    private val wall: InstantSource,
    private val steady: InstantSource,
    private val holder: String = Leases.ONE_SERVER,
) {
    private class Standing(
        val link: String,
        val student: String,
        val exercise: String,
        val points: Int?,
        val of: Int?,
        val version: Int?,
        val changedAt: Instant?,
        val exerciseThen: String?,
    )

    /** Notes what differs from what was noted last: new results, points by hand, other rules, other links. */
    fun notice() {
        for (course in courses()) {
            val counting = marks.of(course)
            val changed =
                pairs(course).mapNotNull { one ->
                    val points = counting[one.student]?.get(one.exercise)
                    val of = exercises.find(one.exercise)?.points()?.total() ?: return@mapNotNull null
                    val same = one.points == points && one.exerciseThen == one.exercise && one.of == of
                    val nothing = one.version == null && points == null
                    if (nothing || (one.version != null && same)) null else Change(one, points, of)
                }
            if (changed.isNotEmpty()) database.write { handle -> changed.forEach { note(handle, it) } }
        }
    }

    private class Change(
        val before: Standing,
        val points: Int?,
        val of: Int,
    )

    /** Writes a change, unless another process has written one meanwhile. */
    private fun note(
        handle: Handle,
        change: Change,
    ) {
        val before = change.before
        val now = wall.instant()
        val next = before.changedAt?.plusMillis(1)?.takeIf { it > now } ?: now
        val sql =
            if (before.version == null) {
                """INSERT INTO lti_scores (link_id, student_id, exercise, points, points_of, version, changed_at, due_at)
                   VALUES (:link, :student, :exercise, :points, :of, 1, :changed, :due) ON CONFLICT DO NOTHING"""
            } else {
                """UPDATE lti_scores SET exercise = :exercise, points = :points, points_of = :of, version = version + 1,
                       changed_at = :changed, due_at = :due, tries = 0, fault = NULL
                   WHERE link_id = :link AND student_id = :student AND version = ${before.version}"""
            }
        handle
            .createUpdate(sql)
            .bind("link", before.link)
            .bind("student", before.student)
            .bind("exercise", before.exercise)
            .bind("points", change.points)
            .bind("of", change.of)
            .bind("changed", next.text())
            .bind("due", steady.instant().text())
            .execute()
    }

    /**
     * Gives back what an earlier server left when it ended, for one that starts: all where no other can use the database,
     * and else what one of this name had.
     */
    fun releaseLeft() {
        val release = "UPDATE lti_scores SET lease = NULL, lease_until = NULL WHERE lease IS NOT NULL"
        database.write { if (database.isShared) Lease.releaseHeld(it, release, holder) else it.execute(release) }
    }

    /** Takes at most [most] of what is due and nobody sends who still lives, those that wait longest first, for a while. */
    fun claim(most: Int): List<DueScore> {
        val now = steady.instant()
        if (!anyDue(now)) return emptyList()
        return database.write { handle ->
            val lease = Lease.newToken(holder)
            val taken =
                handle
                    .createQuery("$DUE ORDER BY s.due_at, s.link_id, s.student_id LIMIT $most")
                    .bind("now", now.text())
                    .bind("silent", (now - Leases.LENGTH).text())
                    .map { row, _ -> due(row, lease) }
                    .list()
            for (one in taken) {
                handle
                    .createUpdate(
                        """UPDATE lti_scores SET lease = :lease, lease_until = :until
                           WHERE link_id = :link AND student_id = :student""",
                    ).bind("lease", lease)
                    .bind("until", (now + LEASE).text())
                    .bind("link", one.link)
                    .bind("student", one.student)
                    .execute()
            }
            taken
        }
    }

    /** The platform has taken the points. What changed meanwhile stays due. */
    fun sent(score: DueScore) =
        settle(
            score,
            """sent_points = :points, sent_at = :at, fault = NULL, tries = 0,
               due_at = CASE WHEN version = :version THEN NULL ELSE due_at END""",
            mapOf("points" to score.points, "at" to wall.instant().text(), "version" to score.version),
        )

    /**
     * The platform has not taken them; they are sent again after a while, which grows from try to try.
     *
     * @param fault a word, or the status of the answer
     */
    fun failed(
        score: DueScore,
        fault: String,
    ) {
        val tries =
            database.read { handle ->
                handle
                    .createQuery("SELECT tries FROM lti_scores WHERE link_id = :link AND student_id = :student")
                    .bind("link", score.link)
                    .bind("student", score.student)
                    .mapTo(Int::class.javaObjectType)
                    .findOne()
                    .getOrNull() ?: 0
            }
        settle(
            score,
            "fault = :fault, tries = tries + 1, due_at = :due",
            mapOf("fault" to fault, "due" to (steady.instant() + pause(tries)).text()),
        )
    }

    /** Gives back what was taken and not tried. */
    fun release(score: DueScore) = settle(score, "tries = tries", emptyMap())

    private fun settle(
        score: DueScore,
        change: String,
        values: Map<String, Any?>,
    ) {
        database.write { handle ->
            handle
                .createUpdate(
                    """UPDATE lti_scores SET $change, lease = NULL, lease_until = NULL
                       WHERE link_id = :link AND student_id = :student AND lease = :lease""",
                ).bindMap(values)
                .bind("link", score.link)
                .bind("student", score.student)
                .bind("lease", score.lease)
                .execute()
        }
    }

    /** Remembers a line item that was made or found for a link. */
    fun keepLineItem(
        link: String,
        item: String,
    ) {
        database.write { handle ->
            handle
                .createUpdate("UPDATE lti_links SET line_item = :item WHERE id = :id")
                .bind("item", item)
                .bind("id", link)
                .execute()
        }
    }

    /** Where the scores of a link go, with what the platform calls the link; null where it is gone. */
    fun place(link: String): Pair<ScorePlace, String>? =
        database.read { handle ->
            handle
                .createQuery("SELECT link, line_item, line_items FROM lti_links WHERE id = :id")
                .bind("id", link)
                .map { row, _ ->
                    ScorePlace(row.getString("line_item"), row.getString("line_items")) to row.getString("link")
                }.findOne()
                .getOrNull()
        }

    private fun anyDue(now: Instant): Boolean =
        database.read { handle ->
            handle
                .createQuery("SELECT count(*) FROM lti_scores WHERE due_at <= :now")
                .bind("now", now.text())
                .mapTo(Int::class.javaObjectType)
                .one() > 0
        }

    private fun courses(): List<String> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT DISTINCT course_id FROM lti_contexts
                       JOIN lti_links ON lti_links.platform_id = lti_contexts.platform_id
                           AND lti_links.context = lti_contexts.context
                       WHERE line_item IS NOT NULL OR line_items IS NOT NULL""",
                ).mapTo(String::class.java)
                .list()
        }

    private fun pairs(course: String): List<Standing> =
        database.read { handle ->
            handle
                .createQuery(
                    """SELECT l.id, l.exercise, p.student_id, s.points, s.points_of, s.version, s.changed_at,
                           s.exercise AS exercise_then
                       FROM lti_links l
                       JOIN lti_contexts c ON c.platform_id = l.platform_id AND c.context = l.context
                       JOIN lti_students p ON p.platform_id = l.platform_id AND p.course_id = c.course_id
                       LEFT JOIN lti_scores s ON s.link_id = l.id AND s.student_id = p.student_id
                       WHERE c.course_id = :course AND (l.line_item IS NOT NULL OR l.line_items IS NOT NULL)""",
                ).bind("course", course)
                .map { row, _ ->
                    Standing(
                        row.getString("id"),
                        row.getString("student_id"),
                        row.getString("exercise"),
                        row.getInt("points").takeUnless { row.wasNull() },
                        row.getInt("points_of").takeUnless { row.wasNull() },
                        row.getInt("version").takeUnless { row.wasNull() },
                        row.getString("changed_at")?.let(Instant::parse),
                        row.getString("exercise_then"),
                    )
                }.list()
        }

    private fun due(
        row: ResultSet,
        lease: String,
    ) = DueScore(
        row.getString("link_id"),
        row.getString("student_id"),
        row.getString("platform_id"),
        row.getString("subject"),
        row.getString("exercise"),
        row.getInt("points").takeUnless { row.wasNull() },
        row.getInt("points_of"),
        row.getInt("version"),
        row.getString("changed_at"),
        lease,
    )

    internal companion object {
        /** How long whoever has taken something has it, which is longer than sending it can take. */
        val LEASE: Duration = Duration.ofMinutes(10)
        private val FIRST_PAUSE: Duration = Duration.ofSeconds(15)
        private val LONGEST_PAUSE: Duration = Duration.ofHours(6)
        private const val MOST_DOUBLINGS = 16

        /** How long after a number of tries the next one is made. */
        fun pause(tries: Int): Duration =
            minOf(FIRST_PAUSE.multipliedBy(1L shl minOf(tries, MOST_DOUBLINGS)), LONGEST_PAUSE)

        /** A lease begins with the name of the server that has it, which is silent for too long. */
        private const val LOST =
            """EXISTS (SELECT 1 FROM workers WHERE seen_at < :silent
                   AND substr(s.lease, 1, length(workers.name) + 1) = workers.name || ' ')"""

        private const val DUE =
            """SELECT s.*, p.platform_id, p.subject FROM lti_scores s
               JOIN lti_links l ON l.id = s.link_id
               JOIN lti_contexts c ON c.platform_id = l.platform_id AND c.context = l.context
               JOIN lti_students p ON p.student_id = s.student_id AND p.platform_id = l.platform_id
                   AND p.course_id = c.course_id
               WHERE s.due_at <= :now AND (s.lease_until IS NULL OR s.lease_until <= :now OR $LOST)"""
    }
}
