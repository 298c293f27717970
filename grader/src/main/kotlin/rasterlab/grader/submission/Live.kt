package rasterlab.grader.submission

import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.update
import rasterlab.exercises.score.CaseReport

/**
 * The present progress, for those who watch: cases judged so far, and a counter that grows whenever the queue moves. Watchers read the rest from the database, so a missed count costs nothing.
 *
 * @param tell passes on to other processes that the queue moved here
 */
class Live(
    private val tell: () -> Unit = {},
) {
    private val moves = MutableStateFlow(0L)
    private val running = MutableStateFlow<Map<String, List<CaseReport>>>(emptyMap())

    /** How far things are: for one submission its own cases count, for all submissions everyone's. */
    data class Stand(
        val moves: Long,
        val cases: Int,
    )

    /** The queue moved, which may change the place of any submission. */
    fun announce() {
        heard()
        tell()
    }

    /** The queue moved in another process. */
    fun heard() = moves.update { it + 1 }

    /** Concerns only those who watch this submission. */
    fun judged(
        submission: String,
        case: CaseReport,
    ) = running.update { it + (submission to it[submission].orEmpty() + case) }

    /** Cases of the running attempt, in order. */
    fun casesOf(submission: String): List<CaseReport> = running.value[submission].orEmpty()

    /** The attempt is over, one way or the other. */
    fun ended(submission: String) {
        running.update { it - submission }
        announce()
    }

    /** @param submission the one that is watched, or null for all */
    fun stand(submission: String?) = standOf(submission, moves.value, running.value)

    /** Returns as soon as things stand otherwise than when they were [seen]. */
    suspend fun awaitChange(
        submission: String?,
        seen: Stand,
    ) {
        combine(moves, running) { count, cases -> standOf(submission, count, cases) }.first { it != seen }
    }

    private fun standOf(
        submission: String?,
        moves: Long,
        running: Map<String, List<CaseReport>>,
    ) = Stand(moves, if (submission == null) running.values.sumOf { it.size } else running[submission].orEmpty().size)
}
