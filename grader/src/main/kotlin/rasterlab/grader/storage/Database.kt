// What lasts: the database, the folder that one server has to itself, ids, tokens and repeatable requests.
package rasterlab.grader.storage

import com.zaxxer.hikari.HikariConfig
import com.zaxxer.hikari.HikariDataSource
import io.micrometer.core.instrument.MeterRegistry
import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.Jdbi
import org.jdbi.v3.core.statement.StatementExceptions
import org.postgresql.PGConnection
import org.sqlite.SQLiteConfig
import org.sqlite.SQLiteDataSource
import java.nio.file.Files
import java.nio.file.Path
import java.time.Instant
import javax.sql.DataSource

/**
 * A database with any number of readers and one writer at a time, in one of two engines.
 *
 * SQLite: each write is an IMMEDIATE transaction on the one writing connection of one process (`synchronous=FULL`; see
 * https://www.sqlite.org/pragma.html#pragma_synchronous). PostgreSQL: each write first takes the one lock of the database
 * that all writers of all processes take, and has it until its end, so that what holds for the one holds for the other.
 * With either engine a write is on the disk when [write] returns.
 *
 * @param folder on the disk whose room counts
 * @param listening makes connections on which other processes are heard
 * @param named ends when the database is closed, and keeps other processes of the same name away until then
 */
class Database private constructor(
    private val folder: Path,
    private val writer: HikariDataSource,
    private val reader: HikariDataSource,
    private val firstInWrite: String? = null,
    private val named: NameLock? = null,
    private val listening: DataSource? = null,
) : AutoCloseable {
    private val writes = silentAboutValues(writer)
    private val reads = silentAboutValues(reader)

    /** The connections for the scheduler, which commits each of its statements by itself. */
    val scheduling: DataSource get() = writer

    /** Whether several processes may grade what is in it. */
    val isShared: Boolean get() = firstInWrite != null

    /** Reads the database's own clock, which all who share it follow; null where one process has it to itself. */
    fun now(): Instant? = if (isShared) read { it.createQuery(CLOCK).mapTo(Instant::class.java).one() } else null

    /** Tells all processes that share the database, this one among them. */
    fun tell(what: String) {
        if (!isShared) return
        writer.connection.use { connection ->
            connection.prepareStatement("SELECT pg_notify('$CHANNEL', ?)").use {
                it.setString(1, what)
                it.execute()
            }
        }
    }

    /**
     * Calls [heard] with each thing that a process tells, until this thread is interrupted.
     *
     * @throws SQLException where the connection is lost
     */
    fun listen(heard: (String) -> Unit) {
        val source = listening ?: return
        source.connection.use { connection ->
            connection.createStatement().use { it.execute("LISTEN $CHANNEL") }
            val talk = connection.unwrap(PGConnection::class.java)
            while (!Thread.currentThread().isInterrupted && connection.isValid(POSTGRES_SECONDS)) {
                talk.getNotifications(LISTEN_MILLIS).orEmpty().forEach { heard(it.parameter) }
            }
        }
    }

    fun <T> read(work: (Handle) -> T): T = reads.withHandle<T, Exception> { work(it) }

    /** Commits when [work] returns, rolls back when it throws. */
    fun <T> write(work: (Handle) -> T): T =
        writes.inTransaction<T, Exception> { handle ->
            firstInWrite?.let { handle.execute(it) }
            work(handle)
        }

    /**
     * Whether no other process has the name of this one. The name is taken again where it was lost, as with a database
     * that was started again.
     */
    fun keepsName(): Boolean = named?.isKept() ?: true

    /**
     * Lets go of the connections that nobody uses now. Those to a database that was away are dead, and each would fail once
     * more when that is back.
     */
    fun dropIdle() = listOf(writer, reader).forEach { it.hikariPoolMXBean?.softEvictConnections() }

    /** Whether the disk can still take a submission and its result. */
    fun hasRoom(): Boolean = freeBytes() >= LEAST_FREE_BYTES

    /** The room on the disk; it is asked for by name, since where no file is left none can be opened. */
    fun freeBytes(): Long = folder.toFile().usableSpace

    /** Lets [registry] count and time how the connections are used from now on. */
    fun measure(registry: MeterRegistry) = listOf(writer, reader).forEach { it.metricRegistry = registry }

    override fun close() {
        reader.close()
        writer.close()
        named?.close()
    }

    companion object {
        // A failed statement would otherwise repeat its values, sources and hashes of tokens among them, in the log.
        private fun silentAboutValues(source: DataSource) =
            Jdbi
                .create(source)
                .registerArgument(TextWithoutNul)
                .configure(StatementExceptions::class.java) {
                    it.messageRendering = StatementExceptions.MessageRendering.NONE
                }

        private const val LEAST_FREE_BYTES = 64L shl 20
        private const val READERS = 4
        private const val BUSY_MILLIS = 5_000

        /** The pool takes no shorter time. */
        private const val LEAST_PATIENCE_MILLIS = 250L

        /** The connection counts as lost when an answer takes longer, and the lock is free again when its holder is silent. */
        private const val POSTGRES_SECONDS = 30

        /** The number of a lock, beside those of [NameLock]; any other programs in the database must not use it. */
        private const val WRITE_LOCK = 7_271_001L

        private const val CHANNEL = "rasterlab"
        private const val LISTEN_MILLIS = 1_000

        private const val CLOCK = "SELECT clock_timestamp()"

        /**
         * Opens the file, creating or migrating its tables.
         *
         * @param busyMillis how long a statement waits for another process that has the database
         * @throws NewerTables
         */
        fun open(
            file: Path,
            busyMillis: Int = BUSY_MILLIS,
        ): Database {
            val source = source(file, busyMillis)
            Tables(source).migrate()
            val reading = listOf("PRAGMA query_only = ON")
            return Database(
                file.toAbsolutePath().parent,
                pool("writer", source, 1, busyMillis),
                pool("readers", source, READERS, busyMillis, reading),
            )
        }

        /**
         * Connects to a PostgreSQL server, creating or migrating the tables.
         *
         * @param folder on this machine, where the server writes its log
         * @param name which no other process may have that uses the database; null for a command, which grades nothing
         * @throws CannotStart if nobody answers there, or another process of that name uses it
         * @throws NewerTables
         */
        fun open(
            address: PostgresAddress,
            folder: Path,
            name: String?,
        ): Database {
            address.requireAnswer()
            val lock = name?.let { NameLock.take(address, it) }
            // Large courses take their time to migrate.
            Tables(address.source(patienceSeconds = 0)).migrate()
            val source = address.source(POSTGRES_SECONDS)
            val writing =
                listOf(
                    "SET synchronous_commit = on",
                    "SET lock_timeout = ${2 * BUSY_MILLIS}",
                    "SET idle_in_transaction_session_timeout = '${POSTGRES_SECONDS}s'",
                )
            val reading = listOf("SET SESSION CHARACTERISTICS AS TRANSACTION READ ONLY")
            return Database(
                folder,
                pool("writer", source, 1, BUSY_MILLIS, writing),
                pool("readers", source, READERS, BUSY_MILLIS, reading),
                "SELECT pg_advisory_xact_lock($WRITE_LOCK)",
                lock,
                source,
            )
        }

        /** @param first what each new connection does before all else */
        private fun pool(
            name: String,
            source: DataSource,
            size: Int,
            busyMillis: Int,
            first: List<String> = emptyList(),
        ) = HikariDataSource(
            HikariConfig().apply {
                poolName = name
                dataSource = source
                maximumPoolSize = size
                connectionTimeout = maxOf(2L * busyMillis, LEAST_PATIENCE_MILLIS)
                if (first.isNotEmpty()) connectionInitSql = first.joinToString("; ")
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
