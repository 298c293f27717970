package rasterlab.grader.storage

import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.JdbiException
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * Commits at once what several threads write at the same time: the disk is waited for once, not once for each of them (group
 * commit, DeWitt and others 1984). Each is on the disk when its call returns, and takes back what it wrote when it throws,
 * whatever comes of the others.
 */
class SharedWrites(
    private val database: Database,
) {
    private val turn = ReentrantLock()
    private val waiting = ConcurrentLinkedQueue<SharedWrite<*>>()

    /** Commits when [work] returns, rolls back when it throws. */
    fun <T> write(work: (Handle) -> T): T {
        val mine = SharedWrite(work)
        waiting += mine
        turn.withLock { while (!mine.isOver) commit(generateSequence(waiting::poll).take(MOST).toList()) }
        return mine.outcome()
    }

    private fun commit(together: List<SharedWrite<*>>) {
        val failure =
            runCatching { database.write { handle -> together.forEach { it.run(handle) } } }.exceptionOrNull()
        together.forEach { it.end(failure) }
    }

    private class SharedWrite<T>(
        private val work: (Handle) -> T,
    ) {
        private var result: Result<T>? = null
        var isOver = false
            private set

        /** @throws Throwable where what was written cannot be taken back, as after some errors of a full disk */
        fun run(handle: Handle) {
            handle.savepoint(SAVEPOINT)
            result =
                runCatching { work(handle) }
                    .onSuccess { handle.releaseSavepoint(SAVEPOINT) }
                    .onFailure { takeBack(handle, it) }
        }

        private fun takeBack(
            handle: Handle,
            failure: Throwable,
        ) {
            try {
                handle.rollbackToSavepoint(SAVEPOINT)
            } catch (lost: JdbiException) {
                failure.addSuppressed(lost)
                throw failure
            }
        }

        /** @param failure of the commit; null where all is on the disk */
        fun end(failure: Throwable?) {
            failure?.let { result = Result.failure(it) }
            isOver = true
        }

        fun outcome(): T = checkNotNull(result) { "nobody did this write" }.getOrThrow()
    }

    private companion object {
        const val SAVEPOINT = "each"

        /** The most that one commit takes: who comes later does not wait for a whole class. */
        const val MOST = 64
    }
}
