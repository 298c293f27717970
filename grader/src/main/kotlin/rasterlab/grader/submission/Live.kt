package rasterlab.grader.submission

import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.asStateFlow
import kotlinx.coroutines.flow.update
import rasterlab.exercises.score.CaseReport
import java.util.concurrent.ConcurrentHashMap

/**
 * What happens just now, for those who watch: cases judged so far, and a counter that grows whenever
 * there may be something new. Watchers read the rest from the database, so a missed count costs nothing.
 */
class Live {
    private val counter = MutableStateFlow(0L)
    private val running = ConcurrentHashMap<String, List<CaseReport>>()

    val changes: StateFlow<Long> = counter.asStateFlow()

    fun announce() = counter.update { it + 1 }

    fun judged(
        submission: String,
        case: CaseReport,
    ) {
        running.merge(submission, listOf(case)) { earlier, new -> earlier + new }
        announce()
    }

    /** Cases of the running attempt, in order. */
    fun casesOf(submission: String): List<CaseReport> = running[submission].orEmpty()

    /** The attempt is over, one way or the other. */
    fun ended(submission: String) {
        running.remove(submission)
        announce()
    }
}
