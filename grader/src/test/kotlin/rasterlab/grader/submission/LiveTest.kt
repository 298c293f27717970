package rasterlab.grader.submission

import kotlinx.coroutines.CoroutineStart.UNDISPATCHED
import kotlinx.coroutines.async
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.Classroom

class LiveTest {
    private val live = Live()
    private val case: CaseReport =
        Classroom
            .report(GradingVerdict.OK, ScorePoints(6, 3, 1, 10))
            .cases()
            .first()

    @Test
    fun `each case wakes those who watch another submission`() {
        val other = live.stand("other")
        val own = live.stand("own")
        val all = live.stand(null)
        live.judged("own", case)
        assertEquals(other, live.stand("other"))
        assertNotEquals(own, live.stand("own"))
        assertNotEquals(all, live.stand(null))
    }

    @Test
    fun `an attempt that ends leaves its watcher or the ones behind it asleep`() =
        runBlocking {
            live.judged("own", case)
            val watchers =
                listOf("own", "other", null).map {
                    val seen = live.stand(it)
                    async(start = UNDISPATCHED) { live.awaitChange(it, seen) }
                }
            live.ended("own")
            watchers.forEach { it.await() }
        }
}
