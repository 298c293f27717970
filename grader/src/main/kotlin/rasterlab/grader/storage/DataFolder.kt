package rasterlab.grader.storage

import rasterlab.grader.storage.CannotStart.StartFailure
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.AccessDeniedException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.nio.file.attribute.PosixFilePermissions
import kotlin.io.path.absolute
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.isSymbolicLink
import kotlin.io.path.readSymbolicLink
import kotlin.io.path.setPosixFilePermissions

/** A folder, and the database in it or in a file elsewhere, that one server has to itself until it closes them. */
class DataFolder private constructor(
    val database: DatabasePlace,
    val logFile: Path,
    private val locks: List<FileChannel>,
) : AutoCloseable {
    /** The file of a database that is in one. */
    val databaseFile: Path get() = (database as SqliteFile).path

    /** Lets go of the locks; the system does so too when the process dies. */
    override fun close() = locks.forEach(FileChannel::close)

    companion object {
        /**
         * @param folder made if missing
         * @param url of the database, or null for the one in the folder
         * @param used the reason to tell where a server uses it
         * @throws CannotStart if the folder cannot be used or a server uses it
         */
        fun take(
            folder: Path,
            url: String?,
            used: StartFailure = StartFailure.USED,
        ): DataFolder {
            val whole = folder.absolute().normalize()
            val address = url?.let { PostgresAddress.of(it) }
            if (address != null) return beside(address, whole, used)
            if (url != null) refuseEarly(whole, url, used)
            make(whole)
            val data = folder.toRealPath()
            val file = fileIn(data, url)
            val locks =
                listOf(data.resolve("server.lock"), lockOf(file)).map { lock(it, used) }
            try {
                makeOwnerOnly(file)
                listOf(
                    "-wal",
                    "-shm",
                ).map { file.resolveSibling("${file.fileName}$it") }.filter { it.exists() }.forEach(::ownerOnly)
            } catch (failure: IOException) {
                locks.forEach(FileChannel::close)
                throw CannotStart(StartFailure.WRITTEN, file.parent, file.fileName, why(failure))
            }
            return DataFolder(SqliteFile(file), data.resolve("server.log"), locks)
        }

        /** The folder of a server whose database is on another, and which has to answer before anything is made here. */
        private fun beside(
            address: PostgresAddress,
            folder: Path,
            used: StartFailure,
        ): DataFolder {
            address.requireAnswer()
            make(folder)
            val data = folder.toRealPath()
            return DataFolder(address, data.resolve("server.log"), listOf(lock(data.resolve("server.lock"), used)))
        }

        /**
         * The database of a server that may be running.
         *
         * @throws CannotStart if there is none
         */
        fun databaseOf(
            folder: Path,
            url: String?,
        ): DatabasePlace {
            url?.let { PostgresAddress.of(it) }?.let { return it }
            val file = fileIn(folder.absolute().normalize(), url)
            if (!file.isRegularFile()) throw CannotStart(StartFailure.NO_DATABASE, file)
            return SqliteFile(file)
        }

        /** Refuses a database that cannot be one, or that a server uses, while nothing is made yet. */
        private fun refuseEarly(
            folder: Path,
            url: String,
            used: StartFailure,
        ) {
            val named = named(url)
            // Its folder may be the one that is still to be made.
            if (named.parent == folder && !folder.exists()) return
            val file = fileIn(folder, url)
            val lock = lockOf(file)
            if (lock.exists()) lock(lock, used).close()
        }

        private fun lockOf(file: Path) = file.resolveSibling("${file.fileName}.lock")

        /**
         * The file under its one name, whatever links and spellings lead there, so that all who use
         * it meet at one lock.
         */
        private fun fileIn(
            data: Path,
            url: String?,
        ): Path {
            val file = if (url == null) data.resolve("rasterlab.db") else fileOf(url)
            return when {
                file.exists() -> {
                    file.toRealPath().also(::refuseOtherNames)
                }

                file.isSymbolicLink() -> {
                    file.parent
                        .toRealPath()
                        .resolve(file.readSymbolicLink())
                        .normalize()
                }

                file.parent.exists() -> {
                    file.parent.toRealPath().resolve(file.fileName)
                }

                else -> {
                    file
                }
            }
        }

        /** Refuses a file with a second name, under which its journal would be another file. */
        private fun refuseOtherNames(file: Path) {
            if ("unix" !in file.fileSystem.supportedFileAttributeViews()) return
            val names = Files.getAttribute(file, "unix:nlink") as Int
            if (names > 1) throw CannotStart(StartFailure.DB_LINKED, file, names)
        }

        private fun fileOf(url: String): Path {
            val file = named(url)
            if (!file.parent.isDirectory()) throw CannotStart(StartFailure.DB_NONE, url, file.parent)
            return file
        }

        private fun named(url: String): Path {
            val name = url.removePrefix("jdbc:").takeIf { it.startsWith("sqlite:") }?.removePrefix("sqlite:")
            if (name == null) throw CannotStart(StartFailure.DB_KIND, url)
            val plain = name.isNotEmpty() && name.none { it in "?:" }
            if (!plain) throw CannotStart(StartFailure.DB_NAME, url)
            val file = Path.of(name).absolute().normalize()
            if (file.isDirectory()) throw CannotStart(StartFailure.DB_FOLDER, url)
            return file
        }

        private fun make(folder: Path) {
            if (folder.isDirectory()) return
            val standing = generateSequence(folder) { it.parent }.first { Files.exists(it) }
            if (!standing.isDirectory()) throw CannotStart(StartFailure.DATA_FILE, folder, standing)
            val views = folder.fileSystem.supportedFileAttributeViews()
            try {
                Files.createDirectories(folder)
                if ("posix" in views) folder.setPosixFilePermissions(OWNER_ONLY)
            } catch (failure: IOException) {
                throw CannotStart(StartFailure.DATA_MADE, folder, standing, why(failure))
            }
        }

        /**
         * The reason: in brackets what the system says beside the place; nothing where it only
         * names that.
         */
        private fun why(failure: IOException): String {
            val said = if (failure is FileSystemException) failure.reason else failure.message
            return if (failure is AccessDeniedException || said == null) "" else " ($said)"
        }

        private val OWNER_ONLY = PosixFilePermissions.fromString("rwx------")

        private fun lock(
            file: Path,
            used: StartFailure,
        ): FileChannel {
            try {
                makeOwnerOnly(file)
                val channel = FileChannel.open(file, CREATE, WRITE)
                if (channel.tryLock() != null) return channel
                channel.close()
            } catch (failure: OverlappingFileLockException) {
                throw CannotStart(used, file.parent)
            } catch (failure: IOException) {
                throw CannotStart(StartFailure.WRITTEN, file.parent, file.fileName, why(failure))
            }
            throw CannotStart(used, file.parent)
        }
    }
}
