package rasterlab.grader.storage

import io.micrometer.core.instrument.simple.SimpleMeterRegistry
import org.jdbi.v3.core.Handle
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CompletableFuture.supplyAsync
import java.util.concurrent.CountDownLatch
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors
import java.util.concurrent.locks.LockSupport

/** Several threads write while another commits, and all of them are committed together. */
@Timeout(60)
class SharedWritesTest {
    @TempDir
    lateinit var folder: Path
    private lateinit var database: Database
    private lateinit var writes: SharedWrites
    private val threads = Executors.newCachedThreadPool()

    @BeforeEach
    fun open() {
        database = Database.open(folder.resolve("test.db"))
        writes = SharedWrites(database)
    }

    @AfterEach
    fun close() {
        threads.shutdownNow()
        database.close()
    }

    @Test
    @DisplayName("each that waits is committed alone, or one is forgotten")
    fun whatWaitsIsCommittedTogether() {
        val meters = SimpleMeterRegistry()
        database.measure(meters)
        together((1..100).map { name -> { handle: Handle -> course(handle, "c$name") } }).forEach { it.get() }
        val commits = meters.find("hikaricp.connections.usage").timers().sumOf { it.count() }
        assertEquals(3, commits, "of the first, and of 64 and 36 that waited")
        assertEquals((0..100).map { "c$it" }.sorted(), courses())
    }

    @Test
    @DisplayName("one that fails takes others with it, leaves what it wrote, or is told something else")
    fun failureIsItsOwn() {
        val done =
            together(
                listOf(
                    { course(it, "before") },
                    { course(it, "failed").also { throw IllegalStateException("mine") } },
                    { course(it, "after") },
                ),
            )
        assertEquals("mine", assertThrows(ExecutionException::class.java) { done[1].get() }.cause?.message)
        done[0].get()
        done[2].get()
        assertEquals(listOf("after", "before", "c0"), courses())
    }

    @Test
    @DisplayName("who is not on the disk is told that all is well")
    fun failedCommitIsToldToAll() {
        val done =
            together(
                listOf(
                    { course(it, "one") },
                    {
                        it.execute("PRAGMA defer_foreign_keys = ON")
                        it.execute(
                            "INSERT INTO students (id, course_id, name, token_hash, joined_at) VALUES ('s', 'none', '', '', '')",
                        )
                    },
                ),
            )
        done.forEach { assertThrows(ExecutionException::class.java) { it.get() } }
        assertEquals(listOf("c0"), courses())
    }

    /** Has them wait behind one that has not ended, in their order. */
    private fun <T> together(works: List<(Handle) -> T>): List<CompletableFuture<T>> {
        val begun = CountDownLatch(1)
        val go = CountDownLatch(1)
        val first =
            supplyAsync({
                writes.write {
                    begun.countDown()
                    go.await()
                    course(it, "c0")
                }
            }, threads)
        begun.await()
        val done = works.map { work -> waitingFor { writes.write(work) } }
        go.countDown()
        first.get()
        return done
    }

    /** Begins it in a thread that waits by now. */
    private fun <T> waitingFor(write: () -> T): CompletableFuture<T> {
        val outcome = CompletableFuture<T>()
        val thread =
            Thread { runCatching(write).onSuccess(outcome::complete).onFailure(outcome::completeExceptionally) }
        thread.start()
        while (thread.state != Thread.State.WAITING) LockSupport.parkNanos(1_000_000)
        return outcome
    }

    private fun course(
        handle: Handle,
        name: String,
    ) {
        handle.execute("INSERT INTO courses (id, name, code, created_at) VALUES (?, ?, ?, '')", name, name, name)
    }

    private fun courses(): List<String> =
        database.read { it.createQuery("SELECT id FROM courses ORDER BY id").mapTo(String::class.java).list() }
}
