package rasterlab.grader.storage

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.postgres.LocalPostgres
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.postgres.TestDatabases
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Path
import java.sql.SQLException
import java.util.concurrent.CompletableFuture.supplyAsync
import java.util.concurrent.CyclicBarrier
import java.util.concurrent.TimeUnit.MINUTES
import kotlin.io.path.exists

/** Processes that share a database of PostgreSQL, and starts that are refused. */
@OnPostgres
@Tag("slow")
class PostgresTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("two processes write at the same time, and one of them overwrites what the other has just read")
    fun writesOneAfterTheOther() {
        val all = listOf(TestDatabases.open(folder), TestDatabases.open(folder))
        all[0].write { it.execute("INSERT INTO speed_bands VALUES ('count', 0)") }
        val together = CyclicBarrier(all.size)
        all
            .map { database ->
                supplyAsync {
                    together.await()
                    repeat(TIMES) {
                        database.write { handle ->
                            val now =
                                handle
                                    .createQuery(
                                        "SELECT band FROM speed_bands",
                                    ).mapTo(Int::class.javaObjectType)
                                    .one()
                            handle.execute("UPDATE speed_bands SET band = ?", now + 1)
                        }
                    }
                }
            }.forEach { it.join() }
        val counted =
            all[0].read { it.createQuery("SELECT band FROM speed_bands").mapTo(Int::class.javaObjectType).one() }
        assertEquals(all.size * TIMES, counted)
        all.forEach(Database::close)
    }

    @Test
    @DisplayName("a reader writes, or a write is not made sure of")
    fun readsOnlyAndWritesForGood() {
        TestDatabases.open(folder).use { database ->
            val failure = runCatching { database.read { it.execute("DELETE FROM speed_bands") } }.exceptionOrNull()
            assertTrue("read-only" in "${failure?.cause?.message}", "$failure")
            val sure = database.write { it.createQuery("SHOW synchronous_commit").mapTo(String::class.java).one() }
            assertEquals("on", sure)
        }
    }

    @Test
    @DisplayName("a text with a NUL, which PostgreSQL does not store, is answered with a failure")
    fun showsNulAsItsPicture() {
        TestDatabases.open(folder).use { database ->
            database.write {
                it.createUpdate("INSERT INTO speed_bands VALUES (:key, 1)").bind("key", "a\u0000b").execute()
            }
            val kept =
                database.read { it.createQuery("SELECT source_key FROM speed_bands").mapTo(String::class.java).one() }
            assertEquals("a\u2400b", kept)
        }
    }

    @Test
    @DisplayName("a second server takes the leases of the first away")
    fun isOneServersOwn() {
        val address = address("own")
        Database.open(address, folder, "one").use {
            refuses("another process named one is using it") { Database.open(address, folder, "one") }
            Database.open(address, folder, null).close()
        }
        Database.open(address, folder, "one").close()
    }

    @Test
    @DisplayName("after the database was started again, a second process of the same name starts")
    fun keepsItsNameWhenTheDatabaseIsStartedAgain() {
        val address = address("names")
        Database.open(address, folder, "one").use { one ->
            checkNotNull(TestDatabases.server).restart { assertThrows(SQLException::class.java) { one.keepsName() } }
            assertTrue(one.keepsName())
            refuses("another process named one is using it") { Database.open(address, folder, "one") }
        }
    }

    @Test
    @DisplayName("a process whose name another took while the database was away goes on beside it")
    fun knowsThatAnotherHasItsName() {
        val address = address("taken")
        Database.open(address, folder, "one").use { one ->
            checkNotNull(TestDatabases.server).restart {}
            Database.open(address, folder, "one").use { assertEquals(false, one.keepsName()) }
            // the server sees a little later that the other connection has ended
            val end = System.nanoTime() + MINUTES.toNanos(1)
            while (!one.keepsName()) assertTrue(System.nanoTime() < end, "the name is not taken back")
        }
    }

    @Test
    @DisplayName("a start that cannot succeed makes a folder, or does not say why")
    fun saysWhyItDoesNotStart() {
        val free = ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { it.localPort }
        val here = "$postgresAddress"
        for ((words, url) in listOf(
            "no PostgreSQL server answers there" to "postgresql://u@127.0.0.1:$free/n",
            "no PostgreSQL server answers there" to "postgresql://u@no.such.host.invalid/n",
            "does not let this user in" to here.replace("rasterlab@", "${LocalPostgres.LOCKED_OUT}:hush@"),
            "there is no database of this name" to here.replaceAfterLast('/', "none"),
        )) {
            val data = folder.resolve("course")
            val message = refuses(words) { DataFolder.take(data, url) }
            assertTrue("hush" !in message && !data.exists(), message)
        }
    }

    @Test
    @DisplayName("a program takes tables that only a later one understands")
    fun refusesNewerTables() {
        val address = address("newer")
        Database.open(address, folder, null).use { database ->
            database.write {
                it.execute(
                    """INSERT INTO flyway_schema_history
                       SELECT installed_rank + 1, '9000', 'later', type, 'V9000__later.sql', 1, installed_by, installed_on, 1, true
                       FROM flyway_schema_history ORDER BY installed_rank DESC LIMIT 1""",
                )
            }
        }
        assertEquals(
            "9000",
            assertThrows(NewerTables::class.java) { Database.open(address, folder, null) }.version,
        )
    }

    private val postgresAddress get() = address("postgres")

    private fun address(name: String) =
        checkNotNull(PostgresAddress.of(checkNotNull(TestDatabases.server).address(name)))

    private fun refuses(
        words: String,
        start: () -> Unit,
    ): String {
        val message = assertThrows(CannotStart::class.java) { start() }.message
        assertTrue(words in message && '\n' !in message, "expected '$words' in one line, got '$message'")
        return message
    }

    private companion object {
        const val TIMES = 50
    }
}
