package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.postgres.TestDatabases
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource

/** Gives out once what is kept for a browser, whichever process is asked. */
open class OnceOnlyTest {
    @TempDir
    lateinit var folder: Path

    private var now = Instant.parse("2026-03-29T01:00:00Z")
    private val clock = InstantSource { now }

    @Test
    @DisplayName("another process knows nothing of it, or gives it out a second time")
    fun anotherProcessGivesItOut() =
        TestDatabases.open(folder).use { one ->
            TestDatabases.open(folder).use { other ->
                val key = OnceOnly(one, clock, "a").keep("value")
                assertEquals("value", OnceOnly(other, clock, "a").take(key))
                assertEquals(null, OnceOnly(one, clock, "a").take(key))
            }
        }

    @Test
    @DisplayName("it is given out for something else, or late, or lies in the database for whoever reads that")
    fun onlyItsKindAndInTime() =
        TestDatabases.open(folder).use { database ->
            val kept = OnceOnly(database, clock, "a")
            val key = kept.keep("value")
            assertEquals(null, OnceOnly(database, clock, "b").take(key))
            val stored =
                database.read {
                    it
                        .createQuery(
                            "SELECT key_hash FROM once_only",
                        ).mapTo(String::class.java)
                        .one()
                }
            assertEquals(Secrets.hash(key), stored)
            now += OnceOnly.LIFE - Duration.ofMillis(1)
            assertEquals("value", kept.take(key))
            val late = kept.keep("late")
            now += OnceOnly.LIFE
            assertEquals(null, kept.take(late))
            kept.keep("next")
            assertEquals(
                1,
                database.read {
                    it
                        .createQuery(
                            "SELECT count(*) FROM once_only",
                        ).mapTo(Int::class.javaObjectType)
                        .one()
                },
            )
        }

    @Test
    @DisplayName("one who begins again and again fills the disk, or takes others' place first")
    fun theOldestGo() =
        TestDatabases.open(folder).use { database ->
            val kept = OnceOnly(database, clock, "a", most = 2)
            val other = OnceOnly(database, clock, "b", most = 2).keep("other")
            val keys = (1..3).map { number -> kept.keep("$number").also { now += Duration.ofSeconds(1) } }
            assertEquals(listOf(null, "2", "3"), keys.map(kept::take))
            assertEquals("other", OnceOnly(database, clock, "b").take(other))
        }
}

@OnPostgres
class OnceOnlyOnPostgresTest : OnceOnlyTest()
