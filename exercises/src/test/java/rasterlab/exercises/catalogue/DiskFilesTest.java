package rasterlab.exercises.catalogue;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.exercises.CatalogueException;

/** A place that is no folder of exercises is told in one line, and nothing of it is waited for. */
class DiskFilesTest {
    @TempDir Path folder;
    private Path mine;
    private Path file;

    @BeforeEach
    void makeASubFolder() throws IOException {
        mine = Files.createDirectory(folder.resolve("mine"));
        file = mine.resolve("exercise.json");
    }

    private static String refusal(Path folder) {
        String said =
                assertThrows(CatalogueException.class, () -> Catalogue.builtIn().withFolder(folder))
                        .getMessage();
        assertEquals(1, said.lines().count(), said);
        return said;
    }

    @Test
    void tellsAFolderThatIsNotThereAndAFileInItsPlace() throws IOException {
        Path none = folder.resolve("none");
        assertEquals(none + ": no such folder", refusal(none));
        Path text = Files.writeString(folder.resolve("text"), "");
        assertEquals(text + ": is not a folder", refusal(text));
    }

    @Test
    void tellsAMissingFileAndAFolderInItsPlace() throws IOException {
        assertEquals(file + ": no such file to read", refusal(folder));
        Files.createDirectory(file);
        assertEquals(file + ": is a folder, not a file of an exercise", refusal(folder));
    }

    @Test
    @DisplayName("an editor's lock, a link to nothing, stops the server")
    void passesOverNamesThatBeginWithADot() throws IOException {
        Files.delete(mine);
        Files.createSymbolicLink(folder.resolve(".#statement.md"), Path.of("user@host.1"));
        assertEquals(
                Catalogue.builtIn().all().size(),
                Catalogue.builtIn().withFolder(folder).all().size());
    }

    @Test
    @DisplayName("a pipe is waited for")
    void tellsAPipe() throws Exception {
        Path maker = Path.of("/usr/bin/mkfifo");
        assumeTrue(Files.isExecutable(maker), maker + " is missing");
        new ProcessBuilder(maker.toString(), file.toString()).start().waitFor();
        // Who opens it gets a few bytes, so that a test fails and does not hang.
        var writer = new Thread(this::write, "pipe");
        writer.setDaemon(true);
        writer.start();
        assertEquals(
                file + ": is a device, pipe or socket, not a file of an exercise", refusal(folder));
    }

    private void write() {
        try {
            Files.writeString(file, "{}");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    @DisplayName("a link to a device without end is read")
    void tellsALinkToADevice() throws IOException {
        Path zero = Path.of("/dev/zero");
        assumeTrue(Files.exists(zero), zero + " is missing");
        Files.createSymbolicLink(file, zero);
        assertEquals(
                file + ": is a device, pipe or socket, not a file of an exercise", refusal(folder));
    }

    @Test
    void tellsAFileThatIsTooLong() throws IOException {
        try (var sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength((1 << 20) + 1);
        }
        assertEquals(file + " is longer than the allowed 1048576 bytes", refusal(folder));
    }

    @Test
    @DisplayName("an exercise behind a link in a circle or to nowhere is left out silently")
    void tellsLinksThatLeadNowhere() throws IOException {
        Path link = folder.resolve("a-link");
        Files.createSymbolicLink(link, link);
        String circle = refusal(folder);
        assertTrue(circle.startsWith(link + ": cannot be read: Too many"), circle);
        Files.delete(link);
        Files.createSymbolicLink(link, folder.resolve("gone"));
        assertEquals(link + ": is a link to what is not there", refusal(folder));
    }

    /** The test is skipped for a user who may read everything. */
    @Test
    void tellsWhatTheUserHasNoRightTo() throws IOException {
        Files.writeString(file, "{}");
        assertEquals(file + ": no right to read it", refusalOfLocked(file, folder));
        assertEquals(file + ": no right to read it", refusalOfLocked(mine, folder));
        assertEquals(folder + ": no right to list it", refusalOfLocked(folder, folder));
    }

    private static String refusalOfLocked(Path locked, Path folder) throws IOException {
        assumeTrue(Files.getFileStore(locked).supportsFileAttributeView("posix"));
        Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("---------"));
        try {
            assumeFalse(Files.isReadable(locked), "this user may read everything");
            return refusal(folder);
        } finally {
            Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("rwx------"));
        }
    }
}
