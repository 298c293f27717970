package rasterlab.grader.lti

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.patch
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.JsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.score.Message
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.sendForm
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Marks
import rasterlab.grader.worker.Worker
import rasterlab.grader.worker.Workers
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit

/** Points go to the platform, each change once, whatever is away or ends meanwhile. */
@Tag("slow")
open class ScoresTest {
    @TempDir
    lateinit var folder: Path

    private var now = Instant.parse("2026-03-29T12:00:00Z")
    private val clock = InstantSource { now }

    private fun room(
        noItem: Boolean = false,
        test: suspend Visit.(LocalPlatform) -> Unit,
    ) = LocalPlatform().use { platform ->
        Classroom(folder).open(grades = false) {
            register(platform)
            bindCourse(platform)
            if (noItem) withoutItem(platform)
            launch(platform)
            test(platform)
        }
    }

    /** The launch names no line item, and lets one be made. */
    private fun Visit.withoutItem(platform: LocalPlatform) {
        database.write { it.execute("DELETE FROM lti_links") }
        platform.claims = {
            claim(
                "https://purl.imsglobal.org/spec/lti-ags/claim/endpoint",
                mapOf(
                    "scope" to listOf("${LocalPlatform.AGS}/lineitem", "${LocalPlatform.AGS}/score"),
                    "lineitems" to "${platform.issuer}/items",
                ),
            )
        }
    }

    /** Does what a server does by itself; a new one each time, as after a restart. */
    private fun Visit.turn() = sender().use { it.turn() }

    private fun Visit.sender(holder: String = Leases.ONE_SERVER) =
        ScoreSender(
            database,
            Platforms(database, clock),
            ToolKey(database, clock),
            Exercises(listOf(Classroom.EXERCISE)),
            clock,
            clock,
            holder,
        )

    /** A submission that was graded so. */
    private fun Visit.graded(
        points: Int,
        receivedAt: Instant = now,
    ): String {
        val id = Secrets.newId()
        val student = one("SELECT id FROM students")
        val attempt = one("SELECT count(*) FROM submissions").toInt() + 1
        database.write { handle ->
            handle.execute(
                """INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state)
                   VALUES (?, ?, 'draw-dot', 'r1', $attempt, '', 1, ?, 'done')""",
                id,
                student,
                receivedAt.text(),
            )
            result(id, points, run = 1).let { (sql, values) -> handle.execute(sql, *values) }
        }
        return id
    }

    private fun result(
        submission: String,
        points: Int,
        run: Int,
    ): Pair<String, Array<Any>> =
        """INSERT INTO results (id, submission_id, run, is_current, revision, verdict, accuracy, stability, speed, points_of,
               isolation, nanos_per_item, graded_at)
           VALUES (?, ?, $run, 1, 'r1', 'wrong', $points, 0, 0, 10, '', 1.0, ?)""" to
            arrayOf(Secrets.newId(), submission, now.text())

    private fun LocalPlatform.points() = taken.map { it.score["scoreGiven"]?.toString() }

    @Test
    @DisplayName("the score is another student's, of another moment or another shape, or goes to another place")
    fun aScoreArrives() =
        room { platform ->
            graded(4)
            turn()
            val one = platform.taken.single()
            assertEquals("/items/1/lineitem/scores?type=7", one.path)
            val expected =
                """{"userId":"ada-there","timestamp":"2026-03-29T12:00:00.000Z","scoreGiven":4,"scoreMaximum":10,""" +
                    """"activityProgress":"Submitted","gradingProgress":"FullyGraded"}"""
            assertEquals(expected, one.score.toString())
        }

    @Test
    @DisplayName("what has not changed is sent again, or a change by hand, by another result or by a rule is not sent")
    fun eachChangeIsSentOnce() =
        room { platform ->
            turn()
            assertEquals(emptyList<String>(), platform.points())
            val first = graded(4)
            repeat(2) { turn() }
            assertEquals(listOf("4"), platform.points())
            client.patch("/api/v1/submissions/$first/points") {
                bearer(instructor)
                json("""{"points":2,"reason":"fine"}""")
            }
            repeat(2) { turn() }
            assertEquals(listOf("4", "6"), platform.points())
            database.write { handle ->
                handle.execute("UPDATE results SET is_current = 0")
                result(first, 7, run = 2).let { (sql, values) -> handle.execute(sql, *values) }
            }
            repeat(2) { turn() }
            graded(1)
            repeat(2) { turn() }
            assertEquals(listOf("4", "6", "9"), platform.points())
            client.patch("/api/v1/courses/${one("SELECT id FROM courses")}/exercises/draw-dot") {
                bearer(instructor)
                json("""{"policy":"last"}""")
            }
            repeat(2) { turn() }
            assertEquals(listOf("4", "6", "9", "1"), platform.points())
            val moments = platform.taken.map { it.score.text("timestamp") }
            assertEquals(moments.sorted().distinct(), moments, "a platform refuses what is not later")
        }

    @Test
    @DisplayName("practice after the deadline is sent, or what became practice stays at the platform")
    fun practiceStaysHere() =
        room { platform ->
            val course = one("SELECT id FROM courses")

            suspend fun due(at: String) =
                client.patch("/api/v1/courses/$course/exercises/draw-dot") {
                    bearer(instructor)
                    json("""{"deadline":"$at","lateDays":0}""")
                }
            assertEquals(200, due("2026-03-29T11:00:00Z").status.value)
            graded(8)
            database.write { it.execute("UPDATE submissions SET due_at = '2026-03-29T11:00:00.000Z'") }
            turn()
            assertEquals(emptyList<String>(), platform.points())
            database.write { it.execute("UPDATE submissions SET due_at = NULL") }
            due("2026-03-29T13:00:00Z")
            turn()
            assertEquals(listOf("8"), platform.points())
            database.write { it.execute("UPDATE submissions SET due_at = '2026-03-29T11:00:00.000Z'") }
            due("2026-03-29T11:00:00Z")
            repeat(2) { turn() }
            assertEquals(listOf("8", null), platform.points())
            assertEquals(
                "NotReady",
                platform.taken
                    .last()
                    .score
                    .text("gradingProgress"),
            )
        }

    @Test
    @DisplayName("a score is lost while the platform is away, or sent again after it was taken")
    fun whatIsAwayIsTriedAgain() =
        room { platform ->
            graded(4)
            platform.away(gone = true)
            turn()
            assertEquals(
                "away 1 null",
                one("SELECT fault || ' ' || tries || ' ' || coalesce(lease, 'null') FROM lti_scores"),
            )
            platform.away(gone = false)
            turn()
            assertEquals(emptyList<String>(), platform.points())
            now += ScoreOutbox.pause(0)
            turn()
            assertEquals(listOf("4"), platform.points())
            now += Duration.ofDays(2)
            turn()
            assertEquals(1, platform.taken.size)
        }

    @Test
    @DisplayName("a refusal is tried without a pause, counts as taken, or staff neither see it nor can try again")
    fun staffSeeAndTryAgain() =
        room { platform ->
            graded(4)
            platform.status = 403
            repeat(2) { turn() }
            val course = one("SELECT id FROM courses")
            val page =
                client.get(
                    "/instructor/courses/$course/lti",
                ) { header(HttpHeaders.Cookie, cookieOf(instructor)) }
            assertTrue("the platform answers 403" in page.bodyAsText(), page.bodyAsText())
            assertEquals("1", one("SELECT tries FROM lti_scores"))
            platform.status = 200
            turn()
            assertEquals(emptyList<String>(), platform.points())
            database.write { it.execute("UPDATE lti_scores SET due_at = '2199-01-01T00:00:00.000Z'") }
            assertEquals(302, sendForm("/instructor/courses/$course/lti/send", "").status.value)
            now = Instant.now() + Duration.ofMinutes(1)
            turn()
            assertEquals(listOf("4"), platform.points())
            assertEquals("1", one("SELECT count(*) FROM audit WHERE action = 'lti-send'"))
        }

    @Test
    @DisplayName("an answer that was lost, or a server that ended while it sent, makes a score come twice or never")
    fun whatWasTakenIsNotLost() =
        room { platform ->
            graded(4)
            platform.status = 409
            turn()
            assertEquals("4", one("SELECT sent_points FROM lti_scores WHERE due_at IS NULL"))
            platform.status = 200
            graded(6)
            val outbox = outbox()
            outbox.notice()
            val cutOff = outbox.claim(10).single()
            turn()
            assertEquals(emptyList<String>(), platform.points())
            now += ScoreOutbox.LEASE
            turn()
            assertEquals(listOf("6"), platform.points())
            outbox.failed(cutOff, "away")
            turn()
            assertEquals(listOf("6"), platform.points())
        }

    @Test
    @DisplayName("a change while a score is sent is taken for sent")
    fun aChangeMeanwhileStaysDue() =
        room { platform ->
            graded(4)
            val outbox = outbox()
            outbox.notice()
            val sending = outbox.claim(10).single()
            graded(6)
            outbox.notice()
            outbox.sent(sending)
            turn()
            assertEquals(listOf("6"), platform.points())
        }

    @Test
    @DisplayName("a score waits as long for a server that was killed as for one that sends it")
    fun whatADeadServerHadIsSentSoon() =
        room { platform ->
            val workers = Workers(database, clock, Leases.LENGTH)
            workers.begin(Worker("other", "host", serves = true, Message.NONE, slots = 1))
            graded(4)
            outbox("other").run {
                notice()
                assertEquals(1, claim(10).size)
            }
            now += Leases.LENGTH
            turn()
            assertEquals(emptyList<String>(), platform.points())
            now += Duration.ofMillis(1)
            turn()
            assertEquals(listOf("4"), platform.points())
        }

    @Test
    @DisplayName("a server that was killed while it sent a score does not send it when it starts again")
    fun whatItHadItselfIsSentAtTheStart() =
        room { platform ->
            graded(4)
            outbox("first").run {
                notice()
                assertEquals(1, claim(10).size)
            }
            outbox("second").run {
                releaseLeft()
                assertEquals(if (database.isShared) 0 else 1, claim(10).size)
            }
            outbox("first").run {
                releaseLeft()
                assertEquals(1, claim(10).size)
            }
            val taken = CompletableFuture<Unit>()
            platform.onScore = { taken.complete(Unit) }
            sender("first").use {
                it.start()
                taken.get(1, TimeUnit.MINUTES)
            }
            assertEquals(listOf("4"), platform.points())
        }

    @Test
    @DisplayName("a link without a line item gets none, or another one each time")
    fun aLineItemIsMadeOnce() =
        room(noItem = true) { platform ->
            graded(4)
            turn()
            graded(6)
            turn()
            assertEquals(listOf("4", "6"), platform.points())
            assertEquals(listOf("/items/100/scores"), platform.taken.map { it.path }.distinct())
            val item = platform.lineItems.single()
            assertTrue("\"scoreMaximum\":10" in item && "\"resourceLinkId\":\"link-1\"" in item, item)
            database.write { it.execute("UPDATE lti_links SET line_item = NULL") }
            graded(7)
            turn()
            assertEquals("/items/100/scores", platform.taken.last().path)
        }

    @Test
    @DisplayName("a leave that the platform has ended keeps scores from being sent")
    fun aLeaveIsRenewed() =
        room { platform ->
            sender().use { sender ->
                graded(4)
                sender.turn()
                platform.leaves.clear()
                graded(6)
                sender.turn()
            }
            assertEquals(listOf("4", "6"), platform.points())
        }

    @Test
    @DisplayName("a student's data lack what a platform knows, or it stays when they are deleted")
    fun belongsToTheStudentsData() =
        room { platform ->
            graded(4)
            turn()
            val student = one("SELECT id FROM students")
            val kept = client.get("/api/v1/students/$student/export") { bearer(instructor) }.bodyAsText()
            assertTrue("\"subject\":\"ada-there\"" in kept && "\"sentPoints\":4" in kept, kept)
            assertFalse("grace-there" in kept)
            assertEquals(302, sendForm("/instructor/students/$student/delete", "sure=yes").status.value)
            assertEquals("0", one("SELECT count(*) FROM lti_students"))
            assertEquals("0", one("SELECT count(*) FROM lti_scores"))
            turn()
            assertEquals(1, platform.taken.size)
        }

    private fun Visit.outbox(holder: String = Leases.ONE_SERVER) =
        ScoreOutbox(
            database,
            Marks(database),
            Exercises(listOf(Classroom.EXERCISE)),
            clock,
            clock,
            holder,
        )

    private fun JsonObject.text(field: String) = getValue(field).toString().trim('"')
}

@OnPostgres
class ScoresOnPostgresTest : ScoresTest()
