package rasterlab.grader.storage

import org.postgresql.ds.PGSimpleDataSource
import org.postgresql.util.PSQLState
import rasterlab.grader.storage.CannotStart.StartFailure
import java.net.URI
import java.net.URISyntaxException
import java.net.URLDecoder
import java.nio.file.Path
import java.sql.SQLException
import javax.sql.DataSource

/** Tells where the database of a server is; its text names it to people. */
sealed interface DatabasePlace

/** One file, which SQLite reads and writes. */
data class SqliteFile(
    val path: Path,
) : DatabasePlace {
    override fun toString() = "$path"
}

/**
 * A database of a PostgreSQL server, and who opens it. Its text has no password in it.
 *
 * @param password null for what the file ~/.pgpass says, as other programs have it
 */
class PostgresAddress private constructor(
    private val user: String,
    private val password: String?,
    private val host: String,
    private val port: Int,
    private val name: String,
    private val encryption: String?,
) : DatabasePlace {
    /** @param patienceSeconds how long an answer may take before the connection counts as lost; 0 for any time */
    internal fun source(patienceSeconds: Int): DataSource =
        PGSimpleDataSource().also {
            it.serverNames = arrayOf(host)
            it.portNumbers = intArrayOf(port)
            it.databaseName = name
            it.user = user
            it.password = password
            it.sslMode = encryption
            it.connectTimeout = CONNECT_SECONDS
            it.socketTimeout = patienceSeconds
            it.tcpKeepAlive = true
            it.applicationName = "rasterlab"
        }

    /** @throws CannotStart if nobody answers there, or the user is not let in */
    internal fun requireAnswer() {
        try {
            source(CONNECT_SECONDS).connection.close()
        } catch (failure: SQLException) {
            val why = failure.message.orEmpty()
            throw when (failure.sqlState) {
                PSQLState.INVALID_PASSWORD.state, PSQLState.INVALID_AUTHORIZATION_SPECIFICATION.state,
                PSQLState.CONNECTION_REJECTED.state,
                -> {
                    CannotStart(StartFailure.DB_ENTRY, this, why, cause = failure)
                }

                NO_SUCH_DATABASE -> {
                    CannotStart(StartFailure.DB_ABSENT, this, cause = failure)
                }

                PSQLState.CONNECTION_UNABLE_TO_CONNECT.state, PSQLState.CONNECTION_FAILURE.state -> {
                    CannotStart(StartFailure.DB_SILENT, this, cause = failure)
                }

                else -> {
                    CannotStart(StartFailure.DATABASE, this, why, cause = failure)
                }
            }
        }
    }

    override fun toString() = "postgresql://$user@$host:$port/$name"

    companion object {
        private const val PORT = 5432

        /** The state of invalid_catalog_name. */
        private const val NO_SUCH_DATABASE = "3D000"
        private const val CONNECT_SECONDS = 4
        private val ENCRYPTION = Regex("sslmode=(disable|allow|prefer|require|verify-ca|verify-full)")

        /**
         * Reads postgresql://user:password@host:port/name, in which password and port may be left out.
         *
         * @param environment has the password as PGPASSWORD where the address has none
         * @return null for what does not begin like one
         * @throws CannotStart for one that says too little or too much
         */
        fun of(
            url: String,
            environment: Map<String, String> = System.getenv(),
        ): PostgresAddress? {
            val plain = url.removePrefix("jdbc:")
            if (!plain.startsWith("postgresql:") && !plain.startsWith("postgres:")) return null
            val refused = CannotStart(StartFailure.DB_ADDRESS, withoutPassword(url))
            val address =
                try {
                    URI(plain)
                } catch (malformed: URISyntaxException) {
                    // Its message would repeat the password.
                    throw refused
                }
            val name = address.rawPath.orEmpty().removePrefix("/")
            val who = address.rawUserInfo.orEmpty().split(":", limit = 2)
            val encryption = address.query
            val isWhole = address.host != null && name.isNotEmpty() && '/' !in name && who[0].isNotEmpty()
            if (!isWhole || (encryption != null && !ENCRYPTION.matches(encryption))) throw refused
            return PostgresAddress(
                decoded(who[0]),
                who.getOrNull(1)?.let(::decoded) ?: environment["PGPASSWORD"],
                address.host,
                if (address.port < 0) PORT else address.port,
                decoded(name),
                encryption?.substringAfter('='),
            )
        }

        private fun decoded(part: String) = URLDecoder.decode(part.replace("+", "%2B"), Charsets.UTF_8)

        /** Hides all that may be a password in what could not be read. */
        private fun withoutPassword(url: String) = url.replace(Regex("(//[^:/@]*):.*@"), "$1:…@")
    }
}
