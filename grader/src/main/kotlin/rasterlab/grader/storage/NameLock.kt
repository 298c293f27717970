package rasterlab.grader.storage

import java.sql.Connection

/**
 * The name of a process among those that share a database: a lock on a connection of its own, which ends with the process
 * however that ends. Beside it the process has a share of the lock that a server of an earlier version has alone, since
 * that one would take everybody's leases away.
 */
internal class NameLock private constructor(
    private val address: PostgresAddress,
    private val name: String,
    private var connection: Connection?,
) : AutoCloseable {
    /**
     * Whether this process has the name, which is taken again where the connection was lost.
     *
     * @throws java.sql.SQLException while the database is away
     */
    @Synchronized
    fun isKept(): Boolean {
        val lost = connection?.takeIf { !it.isValid(SECONDS) }
        lost?.close()
        if (lost != null) connection = null
        if (connection == null) connection = connect(address, name)
        return connection != null
    }

    @Synchronized
    override fun close() {
        connection?.close()
    }

    companion object {
        /** Numbers of locks, the last with that of a name; any other programs in the database must not use them. */
        private const val SERVER_LOCK = 7_271_002L
        private const val NAME_LOCK = 7_271_003
        private const val SECONDS = 5

        /** The server ends a connection whose other end is gone without a word within a minute, and the lock with it. */
        private const val PROBE =
            "SET tcp_keepalives_idle = 30; SET tcp_keepalives_interval = 10; SET tcp_keepalives_count = 3"

        private const val TAKE =
            "SELECT pg_try_advisory_lock_shared($SERVER_LOCK), pg_try_advisory_lock($NAME_LOCK, %d)"

        /** @throws CannotStart if another process has the name */
        fun take(
            address: PostgresAddress,
            name: String,
        ): NameLock {
            val connection =
                connect(address, name) ?: throw CannotStart(CannotStart.StartFailure.NAME_USED, address, name)
            return NameLock(address, name, connection)
        }

        /** A connection that has the lock, or null where another has it. */
        private fun connect(
            address: PostgresAddress,
            name: String,
        ): Connection? {
            val connection = address.source(patienceSeconds = 0).connection
            val taken =
                connection.createStatement().use { statement ->
                    statement.execute(PROBE)
                    statement.executeQuery(TAKE.format(name.hashCode())).use {
                        it.next() && it.getBoolean(1) && it.getBoolean(2)
                    }
                }
            if (taken) return connection
            connection.close()
            return null
        }
    }
}
