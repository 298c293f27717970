package rasterlab.grader.postgres

import org.junit.jupiter.api.Assumptions.assumeTrue
import org.postgresql.ds.PGSimpleDataSource
import java.io.IOException
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Files
import java.nio.file.Path
import javax.sql.DataSource
import kotlin.io.path.deleteRecursively
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * A PostgreSQL server of this machine's package, with nothing in it, for as long as it is not closed. It refuses to run
 * as root, so it runs as the package's own user then. Where there is no such package, the test is skipped.
 */
class LocalPostgres : AutoCloseable {
    private val programs: Path = requirePrograms()
    private val asRoot = System.getProperty("user.name") == "root"
    private val folder = Files.createTempDirectory("postgres-of-a-test")
    private val port = ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { it.localPort }

    val source: DataSource = source("postgres")

    init {
        if (asRoot) {
            val owner = folder.fileSystem.userPrincipalLookupService.lookupPrincipalByName("postgres")
            Files.setOwner(folder, owner)
        }
        run("initdb", "-D", "$folder/data", "-U", USER, "--auth=trust", "-E", "UTF8", "--locale=C.UTF-8", "--no-sync")
        val rights = folder.resolve("data/pg_hba.conf")
        rights.writeText("host all \"$LOCKED_OUT\" 127.0.0.1/32 scram-sha-256\n" + rights.readText())
        start()
    }

    /** The address of a database, which is made if it is not there yet. */
    fun address(name: String): String {
        source.connection.use { connection ->
            connection.createStatement().use { statement ->
                val isThere =
                    statement
                        .executeQuery(
                            "SELECT 1 FROM pg_database WHERE datname = '$name'",
                        ).use { it.next() }
                if (!isThere) statement.execute("CREATE DATABASE \"$name\"")
            }
        }
        return "postgresql://$USER@127.0.0.1:$port/$name"
    }

    fun source(name: String): DataSource =
        PGSimpleDataSource().apply {
            setURL("jdbc:postgresql://127.0.0.1:$port/$name")
            user = USER
        }

    /** Ends all connections at once, and starts again after [meanwhile]. */
    fun restart(meanwhile: () -> Unit) {
        run("pg_ctl", "-D", "$folder/data", "-m", "immediate", "-w", "stop")
        meanwhile()
        start()
    }

    private fun start() {
        val options = "-p $port -k $folder -c listen_addresses=127.0.0.1 -c fsync=off"
        run("pg_ctl", "-D", "$folder/data", "-o", options, "-l", "$folder/log", "-w", "start")
    }

    override fun close() {
        run("pg_ctl", "-D", "$folder/data", "-m", "immediate", "-w", "stop")
        @OptIn(kotlin.io.path.ExperimentalPathApi::class)
        folder.deleteRecursively()
    }

    private fun run(
        program: String,
        vararg arguments: String,
    ) {
        val unprivileged =
            if (asRoot) listOf("setpriv", "--reuid=postgres", "--regid=postgres", "--clear-groups") else emptyList()
        val output = Files.createTempFile(program, ".log")
        try {
            val process =
                ProcessBuilder(unprivileged + "${programs.resolve(program)}" + arguments)
                    .directory(folder.root.toFile())
                    .redirectErrorStream(true)
                    .redirectOutput(output.toFile())
                    .start()
            if (process.waitFor() != 0) throw IOException("$program: ${Files.readString(output)}")
        } finally {
            Files.delete(output)
        }
    }

    companion object {
        /** A user who needs a password; there is none by this name. */
        const val LOCKED_OUT = "locked-out"

        private const val USER = "rasterlab"

        private fun requirePrograms(): Path {
            val versions = Path.of("/usr/lib/postgresql")
            val found =
                if (versions.exists()) {
                    versions.listDirectoryEntries().map {
                        it.resolve(
                            "bin",
                        )
                    }
                } else {
                    emptyList()
                }
            val programs = found.firstOrNull { it.resolve("initdb").exists() }
            assumeTrue(programs != null, "needs a PostgreSQL server: /usr/lib/postgresql/*/bin/initdb")
            return checkNotNull(programs)
        }
    }
}
