package rasterlab.grader.storage

import org.flywaydb.core.Flyway
import org.flywaydb.core.api.FlywayException
import org.flywaydb.core.api.MigrationState
import java.sql.SQLException
import javax.sql.DataSource

/** The tables are those of a later program, which alone knows what they mean. */
class NewerTables(
    val version: String,
) : Exception("tables of version $version")

/** The tables of a database: as a server of any version left them, or none yet. */
internal class Tables(
    private val source: DataSource,
) {
    /**
     * Brings the tables to this version. SQLite has scripts of its own up to the eleventh and PostgreSQL begins with what
     * they come to; the ones after are the same for both, but for the names of some types.
     *
     * @param target the version to stop at
     * @throws NewerTables
     */
    fun migrate(target: String = "latest") {
        val engine = engine()
        val flyway =
            Flyway
                .configure()
                .dataSource(source)
                .locations("$SCRIPTS/$engine", "$SCRIPTS/shared")
                .placeholders(checkNotNull(TYPES[engine]) { "no tables for $engine" })
                .target(target)
                .load()
        flyway
            .info()
            .applied()
            .lastOrNull { it.state == MigrationState.FUTURE_SUCCESS }
            ?.let { throw NewerTables("${it.version}") }
        flyway.migrate()
    }

    private fun engine(): String =
        try {
            source.connection.use { it.metaData.databaseProductName.lowercase() }
        } catch (failure: SQLException) {
            throw FlywayException("the database does not answer", failure)
        }

    private companion object {
        const val SCRIPTS = "classpath:rasterlab/grader/storage"

        val TYPES =
            mapOf(
                "sqlite" to mapOf("real" to "REAL", "bytes" to "BLOB", "strict" to "STRICT"),
                "postgresql" to mapOf("real" to "DOUBLE PRECISION", "bytes" to "BYTEA", "strict" to ""),
            )
    }
}
