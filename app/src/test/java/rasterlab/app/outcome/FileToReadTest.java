package rasterlab.app.outcome;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.HexFormat;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class FileToReadTest {
    @TempDir Path folder;

    @Test
    void tellsAFolderAndAFileThatIsNotThere() {
        assertEquals(folder + ": is a folder, not a scene", refusal(folder));
        Path none = folder.resolve("none");
        assertEquals(none + ": no such file to read", refusal(none));
    }

    @ParameterizedTest(name = "{0} is called broken text")
    @CsvSource({
        "PNG, 89504e470d0a1a0a0000000d49484452",
        "JPEG, ffd8ffe000104a464946",
        "GIF, 474946383961f0f0",
        "WEBP, 52494646aabbccdd57454250ff",
    })
    void tellsAPicture(String kind, String bytes) throws IOException {
        Path picture =
                Files.write(folder.resolve("one.scene.json"), HexFormat.of().parseHex(bytes));
        assertEquals(
                picture
                        + ": looks like a "
                        + kind
                        + " picture, not a scene; a picture for faces is opened in the lab's tab"
                        + " Hidden surfaces",
                refusal(picture));
        assertEquals(
                picture + ": looks like a " + kind + " picture, not a source",
                assertThrows(Complaint.class, () -> FileToRead.text(picture, FileKind.SOURCE))
                        .getMessage());
    }

    @Test
    @DisplayName("other bytes than text are called a picture")
    void tellsBytesThatAreNoText() throws IOException {
        Path bytes = Files.write(folder.resolve("short"), new byte[] {(byte) 0x89, 'P', 'N'});
        assertEquals(bytes + ": is not UTF-8 text", refusal(bytes));
    }

    @Test
    @DisplayName("a pipe is waited for")
    void tellsAPipe() throws Exception {
        Path pipe = Pipe.at(folder.resolve("pipe"));
        assertEquals(pipe + ": is a device, pipe or socket, not a scene", refusal(pipe));
    }

    @Test
    @DisplayName("a link to a device without end is read, or a link to a file is not")
    void followsLinks() throws IOException {
        Path link = folder.resolve("link");
        Path file = Files.writeString(folder.resolve("file"), "é");
        Files.createSymbolicLink(link, file);
        assertEquals("é", FileToRead.text(link, FileKind.SCENE));
        Path zero = Path.of("/dev/zero");
        assumeTrue(Files.exists(zero), "/dev/zero is missing");
        Files.delete(link);
        Files.createSymbolicLink(link, zero);
        assertEquals(link + ": is a device, pipe or socket, not a scene", refusal(link));
    }

    @ParameterizedTest(name = "more than {0} may have is read")
    @EnumSource(FileKind.class)
    void tellsAFileThatIsTooLarge(FileKind kind) throws IOException {
        Path file = folder.resolve("large");
        try (var sparse = new RandomAccessFile(file.toFile(), "rw")) {
            sparse.setLength(kind.most());
            FileToRead.require(file, kind);
            sparse.setLength(kind.most() + 1L);
        }
        var refusal = assertThrows(Complaint.class, () -> FileToRead.require(file, kind));
        assertEquals(
                "%s: has %d bytes, %s has at most %d"
                        .formatted(file, kind.most() + 1L, kind, kind.most()),
                refusal.getMessage());
    }

    @Test
    @DisplayName("a file that grows while it is read has no end")
    void stopsWhereAFileGrows() throws IOException {
        byte[] all = {1, 2, 3, 4, 5};
        assertArrayEquals(all, bounded(all, 5).readAllBytes());
        for (byte[] into : new byte[][] {new byte[1], new byte[9]}) {
            InputStream in = bounded(all, 4);
            var stopped =
                    assertThrows(
                            Complaint.class,
                            () -> {
                                while (in.read(into) >= 0) continue;
                            });
            assertEquals("grows", stopped.getMessage());
        }
        InputStream one = bounded(all, 1);
        assertEquals(1, one.read());
        assertThrows(Complaint.class, one::read);
    }

    private static InputStream bounded(byte[] all, long most) {
        return new BoundedStream(
                new ByteArrayInputStream(all), most, () -> Complaint.badInput("grows"));
    }

    @Test
    @DisplayName("a link that leads to itself is called missing")
    void tellsALinkToItself() throws IOException {
        Path link = folder.resolve("link");
        Files.createSymbolicLink(link, link);
        String refusal = refusal(link);
        assertEquals(link + ": cannot be read: ", refusal.substring(0, refusal.indexOf("Too")));
    }

    /** The test is skipped for a user who may read everything. */
    @Test
    void tellsAFileThatIsThereButLocked() throws Exception {
        Path locked = locked(Files.createFile(folder.resolve("locked")));
        assertEquals(locked + ": no right to read it", refusal(locked));
    }

    /** The test is skipped for a user who may read everything. */
    @Test
    @DisplayName("what lies in a locked folder is called missing")
    void tellsAFileInALockedFolder() throws Exception {
        Path inside = folder.resolve("locked").resolve("file");
        Files.createDirectory(inside.getParent());
        Files.createFile(inside);
        Path locked = locked(inside.getParent());
        try {
            assertEquals(inside + ": no right to read it", refusal(inside));
        } finally {
            Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("rwx------"));
        }
    }

    private static Path locked(Path file) throws IOException {
        assumeTrue(Files.getFileStore(file).supportsFileAttributeView("posix"));
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("---------"));
        assumeFalse(Files.isReadable(file), "this user may read everything");
        return file;
    }

    private static String refusal(Path file) {
        return assertThrows(Complaint.class, () -> FileToRead.text(file, FileKind.SCENE))
                .getMessage();
    }
}
