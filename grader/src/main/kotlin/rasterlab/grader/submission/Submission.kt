/*
 * A submission from its arrival to its result.
 * Read Submission, Intake, Leases, Attempts, Measurements, Reports, GradingQueue, in this order.
 */
package rasterlab.grader.submission

import java.time.Instant

enum class State {
    QUEUED,
    RUNNING,
    DONE,
    ;

    /** Lower-case, as stored and in the HTTP API. */
    val code get() = name.lowercase()

    companion object {
        fun of(code: String) = entries.single { it.code == code }
    }
}

/**
 * A source that a student handed in; its row decides what happens to it, everything else only reminds.
 *
 * @param revision of the exercise when it was received
 * @param attempt from 1, counted per student and exercise
 * @param seed draws the hidden cases, so that grading again gives the same result
 * @param tries how often grading was begun
 * @param hintCost points that hints cost which were shown before it was received
 * @param penalty percent of its points that it loses for lateness
 * @param dueAt the deadline that held when it was received, or null where there was none
 */
data class Submission(
    val id: String,
    val student: String,
    val exercise: String,
    val revision: String,
    val attempt: Int,
    val source: String,
    val seed: Long,
    val receivedAt: Instant,
    val state: State,
    val tries: Int,
    val hintCost: Int,
    val penalty: Int,
    val dueAt: Instant?,
)
