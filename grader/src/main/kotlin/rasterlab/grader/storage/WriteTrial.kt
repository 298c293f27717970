package rasterlab.grader.storage

import java.time.Duration

/**
 * Finds out whether the database takes writes, by one that leaves nothing behind. One that changes no row would not reach a
 * disk that has become read-only. As each waits for the disk, and anybody may ask, one that went well counts for a while.
 *
 * @param nanos a reading that only grows
 */
class WriteTrial(
    private val database: Database,
    private val nanos: () -> Long = System::nanoTime,
) {
    @Volatile
    private var wentWellAt: Long? = null

    /** @throws org.jdbi.v3.core.JdbiException where the database takes none */
    fun require() {
        val begun = nanos()
        if (wentWellAt?.let { begun - it < COUNTS.toNanos() } == true) return
        try {
            database.write {
                it.execute("INSERT INTO secrets (name, value) VALUES ('$NAME', ?)", ByteArray(1))
                it.execute("DELETE FROM secrets WHERE name = '$NAME'")
            }
        } catch (failure: Exception) {
            database.dropIdle()
            throw failure
        }
        wentWellAt = begun
    }

    private companion object {
        const val NAME = "write-trial"
        val COUNTS: Duration = Duration.ofSeconds(1)
    }
}
