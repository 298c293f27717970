package rasterlab.app.outcome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class WholeFileTest {
    @TempDir Path folder;

    @Test
    void replacesWhatWasThere() throws Exception {
        Path file = folder.resolve("a.txt");
        Files.writeString(file, "a longer text than the new one");
        WholeFile.write(file, "new".getBytes());
        assertEquals("new", Files.readString(file));
        assertEquals(List.of("a.txt"), names());
    }

    @Test
    void failedMoveLeavesNoPart() throws Exception {
        Path file = Files.createDirectories(folder.resolve("a.txt/inner")).getParent();
        var complaint =
                assertThrows(Complaint.class, () -> WholeFile.write(file, "new".getBytes()));
        assertTrue(complaint.getMessage().startsWith(file + ": cannot be written"));
        assertEquals(List.of("a.txt"), names());
    }

    @Test
    void missingFolderAndFolderInPlaceOfTheFileAreRefused() {
        Path file = folder.resolve("no/a.txt");
        assertThrows(Complaint.class, () -> WholeFile.write(file, new byte[1]));
        assertThrows(Complaint.class, () -> WholeFile.requireWritable(file));
        assertThrows(Complaint.class, () -> WholeFile.requireWritable(folder));
    }

    @Test
    void tryingLeavesNothingBehindAndTouchesNothing() throws Exception {
        Path old = Files.writeString(folder.resolve("old.txt"), "old");
        WholeFile.requireWritable(old);
        WholeFile.requireWritable(folder.resolve("new.txt"));
        assertEquals(List.of("old.txt"), names());
        assertEquals("old", Files.readString(old));
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void folderThatTakesNoFilesWhateverTheRightsIsRefused() {
        var complaint =
                assertThrows(
                        Complaint.class, () -> WholeFile.requireWritable(Path.of("/proc/a.txt")));
        assertTrue(
                complaint
                        .getMessage()
                        .startsWith("/proc/a.txt: cannot be written: a file cannot be made in"),
                complaint.getMessage());
    }

    @Test
    void folderToBeMadeIsTriedWithoutMakingIt() throws Exception {
        WholeFile.requireFolderWritable(folder.resolve("no/inner"));
        WholeFile.requireFolderWritable(folder);
        WholeFile.requireFolderWritable(Path.of("no/inner"));
        assertEquals(List.of(), names());
    }

    @Test
    void fileOnTheWayToAFolderIsNamed() throws Exception {
        Path file = Files.writeString(folder.resolve("a.txt"), "mine");
        for (Path wanted : List.of(file, file.resolve("inner"))) {
            var complaint =
                    assertThrows(Complaint.class, () -> WholeFile.requireFolder(wanted), "made");
            assertEquals(file + ": is a file, a folder is wanted", complaint.getMessage());
        }
        assertEquals("mine", Files.readString(file));
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void deviceIsNotReplacedByAFile() {
        assertThrows(Complaint.class, () -> WholeFile.requireWritable(Path.of("/dev/null")));
    }

    private List<String> names() throws Exception {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
