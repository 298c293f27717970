package rasterlab.grader.storage

import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.PosixFilePermissions
import kotlin.io.path.getPosixFilePermissions
import kotlin.io.path.isRegularFile
import kotlin.io.path.setPosixFilePermissions

private val READ_AND_WRITE = PosixFilePermissions.fromString("rw-------")

/** Whether the file system has rights of owner, group and others. */
internal fun Path.hasRights(): Boolean = "posix" in fileSystem.supportedFileAttributeViews()

/** Lets nobody but its owner read a file that is there. */
internal fun ownerOnly(file: Path) {
    if (!file.hasRights() || !file.isRegularFile()) return
    if (!READ_AND_WRITE.containsAll(file.getPosixFilePermissions())) file.setPosixFilePermissions(READ_AND_WRITE)
}

/** Makes a file, if it is missing, that nobody but its owner reads at any moment; one that is there becomes so. */
internal fun makeOwnerOnly(file: Path) {
    if (!file.hasRights()) return
    try {
        Files.createFile(file, PosixFilePermissions.asFileAttribute(READ_AND_WRITE))
    } catch (there: FileAlreadyExistsException) {
        ownerOnly(file)
    }
}
