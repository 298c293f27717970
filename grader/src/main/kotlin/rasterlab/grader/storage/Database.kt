// What lasts: the SQLite file, the folder that one server has to itself, ids, tokens and repeatable requests.
package rasterlab.grader.storage

import com.zaxxer.hikari.HikariConfig
import com.zaxxer.hikari.HikariDataSource
import io.micrometer.core.instrument.MeterRegistry
import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.Jdbi
import org.jdbi.v3.core.statement.StatementExceptions
import org.sqlite.SQLiteConfig
import org.sqlite.SQLiteDataSource
import java.nio.file.Files
import java.nio.file.Path
import javax.sql.DataSource

/**
 * One SQLite file: any number of readers, and one writer at a time.
 *
 * Every write is an IMMEDIATE transaction on the one writing connection and is on the disk when
 * [write] returns (`synchronous=FULL`; see https://www.sqlite.org/pragma.html#pragma_synchronous).
 */
class Database private constructor(
    private val file: Path,
    private val writer: HikariDataSource,
    private val reader: HikariDataSource,
) : AutoCloseable {
    private val writes = silentAboutValues(writer)
    private val reads = silentAboutValues(reader)

    /** The connections for the scheduler, which commits each of its statements by itself. */
    val scheduling: DataSource get() = writer

    fun <T> read(work: (Handle) -> T): T = reads.withHandle<T, Exception> { work(it) }

    /** Commits when [work] returns, rolls back when it throws. */
    fun <T> write(work: (Handle) -> T): T = writes.inTransaction<T, Exception> { work(it) }

    /** Whether the disk can still take a submission and its result. */
    fun hasRoom(): Boolean = freeBytes() >= LEAST_FREE_BYTES

    fun freeBytes(): Long = Files.getFileStore(file).usableSpace

    /** Lets [registry] count and time how the connections are used from now on. */
    fun measure(registry: MeterRegistry) = listOf(writer, reader).forEach { it.metricRegistry = registry }

    override fun close() {
        reader.close()
        writer.close()
    }

    companion object {
        // A failed statement would otherwise repeat its values, sources and hashes of tokens among them, in the log.
        private fun silentAboutValues(source: DataSource) =
            Jdbi.create(source).configure(StatementExceptions::class.java) {
                it.messageRendering = StatementExceptions.MessageRendering.NONE
            }

        private const val LEAST_FREE_BYTES = 64L shl 20
        private const val READERS = 4
        private const val BUSY_MILLIS = 5_000

        /** The pool takes no shorter time. */
        private const val LEAST_PATIENCE_MILLIS = 250L

        /**
         * Opens the file, creating or migrating its tables.
         *
         * @param busyMillis how long a statement waits for another process that has the database
         */
        fun open(
            file: Path,
            busyMillis: Int = BUSY_MILLIS,
        ): Database {
            val source = source(file, busyMillis)
            Tables(source).migrate()
            return Database(file, pool(source, busyMillis, writing = true), pool(source, busyMillis, writing = false))
        }

        private fun pool(
            source: DataSource,
            busyMillis: Int,
            writing: Boolean,
        ) = HikariDataSource(
            HikariConfig().apply {
                poolName = if (writing) "writer" else "readers"
                dataSource = source
                maximumPoolSize = if (writing) 1 else READERS
                connectionTimeout = maxOf(2L * busyMillis, LEAST_PATIENCE_MILLIS)
                if (!writing) connectionInitSql = "PRAGMA query_only = ON"
            },
        )

        private fun source(
            file: Path,
            busyMillis: Int,
        ): DataSource =
            SQLiteDataSource(
                SQLiteConfig().apply {
                    setJournalMode(SQLiteConfig.JournalMode.WAL)
                    setSynchronous(SQLiteConfig.SynchronousMode.FULL)
                    setTransactionMode(SQLiteConfig.TransactionMode.IMMEDIATE)
                    setBusyTimeout(busyMillis)
                    enforceForeignKeys(true)
                },
            ).apply { url = "jdbc:sqlite:$file" }
    }
}
