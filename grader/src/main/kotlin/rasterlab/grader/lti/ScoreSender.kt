package rasterlab.grader.lti

import org.slf4j.LoggerFactory
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.storage.Database
import rasterlab.grader.submission.Leases
import rasterlab.grader.submission.Marks
import java.time.Duration
import java.time.InstantSource
import java.util.concurrent.Executors
import java.util.concurrent.TimeUnit

/**
 * Sends to platforms the points that count of their students, whenever these change. Any number of servers that share the
 * database may do so at the same time.
 *
 * @param wall the clock that platforms are told
 * @param steady the clock of what is due after a while
 * @param holder the name of this server, which no other has that uses the database now
 */
class ScoreSender(
    database: Database,
    private val platforms: Platforms,
    key: ToolKey,
    private val exercises: Exercises,
    wall: InstantSource,
    steady: InstantSource,
    holder: String = Leases.ONE_SERVER,
) : AutoCloseable {
    private val log = LoggerFactory.getLogger(javaClass)
    private val outbox = ScoreOutbox(database, Marks(database), exercises, wall, steady, holder)
    private val calls = PlatformCalls(key, steady)
    private val turns = Executors.newSingleThreadScheduledExecutor { Thread(it, "scores").apply { isDaemon = true } }
    private var failing = false
    private var isTakenUp = false

    /** Sends from now on what changes, until [close], and first what an earlier server of this name had begun to send. */
    fun start() {
        turns.scheduleWithFixedDelay(::tryTurn, 0, PAUSE.toMillis(), TimeUnit.MILLISECONDS)
    }

    /** Notes what has changed, and sends what is due. */
    fun turn() {
        outbox.notice()
        do {
            val due = outbox.claim(AT_ONCE)
            due.groupBy { it.platform }.forEach { (platform, scores) -> send(platform, scores) }
        } while (due.size == AT_ONCE && !turns.isShutdown)
    }

    private fun send(
        id: String,
        scores: List<DueScore>,
    ) {
        val platform = platforms.find(id) ?: return scores.forEach(outbox::release)
        var away: PlatformFault? = null
        for (score in scores) {
            if (turns.isShutdown) {
                outbox.release(score)
                continue
            }
            try {
                away?.let { throw it }
                send(platform, score)
                outbox.sent(score)
            } catch (fault: PlatformFault) {
                log.info("a score for {} waits: {}", platform.name, fault.code)
                outbox.failed(score, fault.code)
                if (fault.asWhole) away = fault
            }
        }
    }

    private fun send(
        platform: Platform,
        score: DueScore,
    ) {
        val (place, link) = outbox.place(score.link) ?: return
        val item = place.lineItem ?: made(platform, place, link, score)
        calls.score(platform, item, score)
    }

    private fun made(
        platform: Platform,
        place: ScorePlace,
        link: String,
        score: DueScore,
    ): String {
        val among = place.lineItems ?: throw PlatformFault("no-line-item", asWhole = false)
        val title = exercises.find(score.exercise)?.title("en") ?: score.exercise
        return calls.lineItem(platform, among, link, score, title).also { outbox.keepLineItem(score.link, it) }
    }

    // The scheduled executor would never call again after an exception.
    private fun tryTurn() {
        try {
            if (!isTakenUp) outbox.releaseLeft()
            isTakenUp = true
            turn()
            failing = false
        } catch (failure: Exception) {
            if (!turns.isShutdown && !failing) log.error("scores are sent when that works again", failure)
            failing = true
        }
    }

    /** Lets the score that is sent just now go through. */
    override fun close() {
        turns.shutdown()
        turns.awaitTermination(STOP_WAIT.toMillis(), TimeUnit.MILLISECONDS)
    }

    companion object {
        /** The leaves that this server asks platforms for. */
        val SCOPES: List<String> = listOf(LaunchMessage.LINE_ITEM, LaunchMessage.SCORE)

        private const val AT_ONCE = 20
        private val PAUSE: Duration = Duration.ofSeconds(5)
        private val STOP_WAIT: Duration = Duration.ofSeconds(6)
    }
}
