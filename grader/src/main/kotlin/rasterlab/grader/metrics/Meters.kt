// What the server counts and times for those who watch it, in Prometheus' text format. Start at Meters.
package rasterlab.grader.metrics

import io.micrometer.core.instrument.FunctionCounter
import io.micrometer.core.instrument.Gauge
import io.micrometer.core.instrument.Timer
import io.micrometer.core.instrument.binder.jvm.JvmMemoryMetrics
import io.micrometer.core.instrument.binder.jvm.JvmThreadMetrics
import io.micrometer.core.instrument.binder.system.FileDescriptorMetrics
import io.micrometer.core.instrument.binder.system.UptimeMetrics
import io.micrometer.prometheusmetrics.PrometheusConfig
import io.micrometer.prometheusmetrics.PrometheusMeterRegistry
import rasterlab.exercises.Grading
import rasterlab.exercises.score.GradingVerdict
import rasterlab.grader.storage.Database
import rasterlab.grader.submission.State
import rasterlab.grader.submission.Submission
import java.time.Duration
import java.time.InstantSource

/**
 * The meters of one server. Their labels are verdicts, states, exercises and pools, which are few; nothing names a
 * person, and nothing that is sent makes a new line.
 *
 * @param children how many processes that compile and run sources live now
 * @param clock tells when submissions are received
 */
class Meters(
    private val database: Database,
    private val children: () -> Int,
    private val clock: InstantSource,
) {
    private val registry = PrometheusMeterRegistry(PrometheusConfig.DEFAULT)

    @Volatile
    private var counted = Counted(emptyMap(), emptyMap(), 0)

    private val waits =
        Timer
            .builder("rasterlab.queue.wait")
            .description("from the receipt of a submission to the beginning of its first attempt")
            .serviceLevelObjectives(*seconds(1, 5, 20, 60, 300))
            .register(registry)

    init {
        State.entries.forEach { state ->
            gauge("rasterlab.submissions", "submissions by state", "state" to state.code) { counted.states[state.code] }
        }
        GradingVerdict.values().forEach { verdict ->
            FunctionCounter
                .builder("rasterlab.results", this) { (it.counted.verdicts[verdict.code()] ?: 0).toDouble() }
                .description("results by verdict")
                .tag("verdict", verdict.code())
                .register(registry)
        }
        gauge("rasterlab.oldest.waiting", "age of the submission that waits longest", unit = "seconds") {
            counted.oldestSeconds
        }
        gauge("rasterlab.heap", "memory that the server's objects take", unit = "bytes") { usedHeap() }
        gauge("rasterlab.disk.free", "room on the disk of the database", unit = "bytes") { database.freeBytes() }
        gauge("rasterlab.children", "processes that compile or run sources, or wait to") { children() }
        database.measure(registry)
        listOf(JvmMemoryMetrics(), JvmThreadMetrics(), FileDescriptorMetrics(), UptimeMetrics())
            .forEach { it.bindTo(registry) }
    }

    /** This grading, timed by exercise. */
    fun timed(grading: Grading) =
        Grading { exercise, source, cases, progress ->
            val begun = System.nanoTime()
            grading.grade(exercise, source, cases, progress).also {
                Timer
                    .builder("rasterlab.grading")
                    .description("time that one attempt took")
                    .tag("exercise", exercise.id())
                    .serviceLevelObjectives(*seconds(1, 2, 5, 10, 30))
                    .register(registry)
                    .record(Duration.ofNanos(System.nanoTime() - begun))
            }
        }

    /** A submission's attempt begins; its later attempts wait for another reason. */
    fun waited(submission: Submission) {
        if (submission.tries > 1) return
        // The clock may have been set back meanwhile.
        waits.record(maxOf(Duration.between(submission.receivedAt, clock.instant()), Duration.ZERO))
    }

    /** All meters as they stand now. */
    fun text(): String {
        counted = database.read { Counted.of(it, clock.instant()) }
        return registry.scrape()
    }

    private fun gauge(
        name: String,
        description: String,
        tag: Pair<String, String>? = null,
        unit: String? = null,
        value: () -> Number?,
    ) {
        val gauge = Gauge.builder(name) { value() ?: 0 }.description(description).baseUnit(unit)
        tag?.let { (key, of) -> gauge.tag(key, of) }
        gauge.strongReference(true).register(registry)
    }

    private fun usedHeap() = Runtime.getRuntime().run { totalMemory() - freeMemory() }

    private fun seconds(vararg all: Long) = all.map(Duration::ofSeconds).toTypedArray()
}
