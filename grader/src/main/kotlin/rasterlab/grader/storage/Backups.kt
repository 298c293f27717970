package rasterlab.grader.storage

import org.sqlite.SQLiteConfig
import org.sqlite.SQLiteErrorCode
import org.sqlite.SQLiteException
import rasterlab.grader.storage.CannotStart.StartFailure
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.StandardOpenOption.WRITE
import java.sql.Connection
import java.sql.SQLException
import kotlin.io.path.absolute
import kotlin.io.path.exists
import kotlin.io.path.fileSize
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/**
 * Copies of a database as it stands at one moment, also while a server writes to it. The files of a running server
 * copied by hand are no such copy: what was written last is not in them yet, or half.
 */
object Backups {
    private const val PATIENCE_MILLIS = 30_000

    /** How many there are of two that every server's database has. */
    private const val TABLES =
        "SELECT count(*) FROM sqlite_schema WHERE name IN ('submissions', 'flyway_schema_history')"

    /** Copies the database to a new file that only its owner reads. */
    fun take(
        database: Path,
        copy: Path,
    ) {
        val whole = copy.absolute().normalize()
        if (whole.isDirectory()) throw CannotStart(StartFailure.BACKUP_IS_FOLDER, copy)
        if (whole.exists()) throw CannotStart(StartFailure.BACKUP_THERE, copy)
        if (!whole.parent.isDirectory()) throw CannotStart(StartFailure.BACKUP_FOLDER, copy, whole.parent)
        beside(whole) { part ->
            open(database).use { from ->
                from.prepareStatement("VACUUM INTO ?").use {
                    it.setString(1, "$part")
                    it.execute()
                }
            }
            checkedDatabase(part)
            onDisk(part)
            Files.move(part, whole)
        }
    }

    /** Looks at a copy where it lies, and leaves nothing beside it. */
    fun refuseUnlessWhole(copy: Path) {
        if (!copy.isRegularFile()) throw CannotStart(StartFailure.BACKUP_NONE, copy)
        checkedDatabase(copy, look = ::openUntouched)
    }

    /**
     * Puts a copy in the place of a database that no server uses.
     *
     * @return where the former database is now, or null if there was none
     */
    fun restore(
        copy: Path,
        database: Path,
    ): Path? {
        if (!copy.isRegularFile()) throw CannotStart(StartFailure.BACKUP_NONE, copy)
        return beside(database) { part ->
            Files.copy(copy, part, REPLACE_EXISTING)
            ownerOnly(part)
            checkedDatabase(part, said = copy)
            onDisk(part)
            val former = putAside(database)
            Files.move(part, database, ATOMIC_MOVE)
            former
        }
    }

    /** Runs [work] with a new file in the folder of [file], which is gone afterwards. */
    private fun <T> beside(
        file: Path,
        work: (Path) -> T,
    ): T {
        try {
            val part = Files.createTempFile(file.parent, file.name, ".part")
            try {
                return work(part)
            } finally {
                files(part).forEach(Files::deleteIfExists)
            }
        } catch (failure: IOException) {
            throw CannotStart(StartFailure.BACKUP_FAILED, file, failure.toString(), cause = failure)
        } catch (failure: SQLException) {
            throw CannotStart(StartFailure.BACKUP_FAILED, file, failure.message.orEmpty(), cause = failure)
        }
    }

    private fun checkedDatabase(
        file: Path,
        said: Path = file,
        look: (Path) -> Connection = ::open,
    ) {
        val (fault, tables) =
            try {
                look(file).use { it.text("PRAGMA quick_check") to it.text(TABLES) }
            } catch (failure: SQLException) {
                if (failure is SQLiteException && failure.resultCode == SQLiteErrorCode.SQLITE_NOTADB) {
                    throw CannotStart(StartFailure.BACKUP_NO_DATABASE, said)
                }
                throw CannotStart(StartFailure.BACKUP_BROKEN, said, failure.message.orEmpty())
            }
        if (fault != "ok") throw CannotStart(StartFailure.BACKUP_BROKEN, said, fault)
        if (tables != "2") throw CannotStart(StartFailure.BACKUP_FOREIGN, said)
    }

    private fun Connection.text(sql: String): String =
        createStatement().use { statement ->
            statement.executeQuery(sql).use {
                it.next()
                it.getString(1)
            }
        }

    /** Moves a database away with what was not yet written into it; it may be broken. */
    private fun putAside(database: Path): Path? {
        // An empty file was made for this restoring only.
        if (!database.exists() || database.fileSize() == 0L) return null
        val former =
            generateSequence(1) { it + 1 }
                .map { database.resolveSibling("${database.name}.before-restore-$it") }
                .first { !it.exists() }
        files(database).zip(files(former)).forEach { (from, to) -> if (from.exists()) Files.move(from, to) }
        return former
    }

    /** SQLite's own files of a database. */
    private fun files(database: Path) = listOf("", "-wal", "-shm").map { database.resolveSibling(database.name + it) }

    private fun onDisk(file: Path) = FileChannel.open(file, WRITE).use { it.force(true) }

    /** No journal of it is read or made; see https://www.sqlite.org/uri.html on "immutable". */
    private fun openUntouched(file: Path): Connection {
        val name =
            file
                .absolute()
                .normalize()
                .toUri()
                .rawPath
        return SQLiteConfig().createConnection("jdbc:sqlite:file:$name?immutable=1")
    }

    private fun open(file: Path): Connection =
        SQLiteConfig().apply { setBusyTimeout(PATIENCE_MILLIS) }.createConnection("jdbc:sqlite:$file")
}
