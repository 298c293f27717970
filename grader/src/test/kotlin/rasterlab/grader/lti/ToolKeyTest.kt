package rasterlab.grader.lti

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.postgres.TestDatabases
import java.nio.file.Path
import java.time.InstantSource
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CyclicBarrier

/** Two servers that share a database change the one key that they have. */
@Tag("slow")
open class ToolKeyTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("of the keys that two servers make at once one is lost, or is read twice or not as it begins to sign")
    fun noKeyIsLost() =
        TestDatabases.open(folder).use { one ->
            TestDatabases.open(folder).use { other ->
                val keys = listOf(one, other).map { ToolKey(it, InstantSource.system()) }
                val first = keys[0].published().single().id
                val atOnce = CyclicBarrier(keys.size)
                val reads =
                    keys.map { key ->
                        CompletableFuture.supplyAsync {
                            atOnce.await()
                            List(ROUNDS) { key.renew(by = "test", key = null).let { key.published() } }
                        }
                    }
                for (read in reads.flatMap { it.get() }) {
                    assertEquals(read.map { it.id }.distinct(), read.map { it.id })
                    assertEquals(1, read.count { it.until == null })
                }
                val made =
                    one.read { handle ->
                        handle.createQuery("SELECT subject FROM audit").mapTo(String::class.java).list()
                    }
                assertEquals(keys.size * ROUNDS, made.size)
                assertEquals((made + first).sorted(), keys[1].published().map { it.id }.sorted())
            }
        }

    private companion object {
        const val ROUNDS = 3
    }
}
