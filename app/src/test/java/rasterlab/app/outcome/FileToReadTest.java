package rasterlab.app.outcome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileToReadTest {
    @TempDir Path folder;

    @Test
    void tellsAFolderAndAFileThatIsNotThere() {
        assertEquals(folder + ": is a folder, not a scene", refusal(folder));
        Path none = folder.resolve("none");
        assertEquals(none + ": no such file to read", refusal(none));
    }

    /** Skipped for a user who may read everything. */
    @Test
    void tellsAFileThatIsThereButLocked() throws Exception {
        assumeTrue(Files.getFileStore(folder).supportsFileAttributeView("posix"));
        Path locked = Files.createFile(folder.resolve("locked"));
        Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("---------"));
        assumeFalse(Files.isReadable(locked));
        assertEquals(locked + ": no right to read it", refusal(locked));
    }

    private static String refusal(Path file) {
        return assertThrows(Complaint.class, () -> FileToRead.require(file, "a scene"))
                .getMessage();
    }
}
