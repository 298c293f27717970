package rasterlab.grader.submission

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.runner.SpeedMemory
import rasterlab.exercises.score.SpeedPoints
import rasterlab.grader.Classroom
import rasterlab.grader.postgres.TestDatabases
import java.nio.file.Path
import java.util.OptionalInt

open class SpeedBandsTest {
    @TempDir
    lateinit var folder: Path
    private val key = SpeedMemory.key(Classroom.EXERCISE, "class Dot {}")

    @Test
    @DisplayName("a server started anew gives a source near the end of a band other points")
    fun aRestartKeepsTheBand() {
        opened { it.keep(key, SpeedPoints.band(1.6, OptionalInt.empty())) }
        opened { assertEquals(0, SpeedPoints.band(1.8, it.band(key))) }
        assertEquals(1, SpeedPoints.band(1.8, OptionalInt.empty()))
    }

    @Test
    @DisplayName("the first band stands for ever")
    fun theLatestBandIsKept() =
        opened {
            it.keep(key, 2)
            it.keep(key, 1)
            assertEquals(OptionalInt.of(1), it.band(key))
        }

    @Test
    @DisplayName("one source has the band of another, or of the same at another exercise")
    fun anotherSourceHasNoBandYet() =
        opened {
            it.keep(key, 0)
            assertEquals(OptionalInt.empty(), it.band(SpeedMemory.key(Classroom.EXERCISE, "class Dot { }")))
        }

    private fun opened(use: (SpeedBands) -> Unit) = TestDatabases.open(folder).use { use(SpeedBands(it)) }
}
