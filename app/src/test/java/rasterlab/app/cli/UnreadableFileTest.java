package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.outcome.Pipe;

/** Files that no command waits for, or says are not there where they are. */
@Tag("slow")
class UnreadableFileTest {
    private static final String TRIANGLE =
            """
            v 0 0 0
            v 1 0 0
            v 0 1 0
            vt 0 0
            usemtl one
            f 1/1 2/1 3/1
            """;

    @TempDir Path folder;

    @BeforeEach
    void writeFiles() throws IOException {
        Files.writeString(folder.resolve("of-pipe.obj"), "mtllib pipe.mtl\n" + TRIANGLE);
        Files.writeString(folder.resolve("pictured.obj"), "mtllib one.mtl\n" + TRIANGLE);
        Files.writeString(folder.resolve("one.mtl"), "newmtl one\nmap_Kd pipe.png\n");
        Files.writeString(
                folder.resolve("one.scene.json"),
                "{\"version\": 1, \"scene\": \"sphere\", \"look\": {\"textureImage\": \"pipe.png\"}}");
    }

    @ParameterizedTest(name = "{1} is waited for by {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "render FOLDER/pipe.scene.json | pipe.scene.json | not a scene",
                "render FOLDER/pipe.obj | pipe.obj | not a model",
                "render FOLDER/one.scene.json | pipe.png | one.scene.json: $.look.textureImage: ",
                "render sphere --texture-image FOLDER/pipe.png | pipe.png | not a picture",
                "render sphere --diff FOLDER/pipe.png | pipe.png | not a picture",
                "opengl --image FOLDER/pipe.png | pipe.png | not a picture",
                "run --scene FOLDER/pipe.scene.json | pipe.scene.json | not a scene",
                "check line-bresenham FOLDER/pipe.java | pipe.java | not a source",
            })
    void pipeIsRefused(String command, String pipe, String part) throws Exception {
        Pipe.at(folder.resolve(pipe));
        Ran ran = lab(command);
        assertComplaint(ran, "is a device, pipe or socket, not a ");
        assertComplaint(ran, part);
    }

    /** A note tells what a model does without. */
    @ParameterizedTest(name = "{1} is waited for by {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "render FOLDER/of-pipe.obj | pipe.mtl"
                        + " | of-pipe.obj:1: material file 'pipe.mtl' was passed over: ",
                "render FOLDER/pictured.obj | pipe.png | one.mtl:2: ",
            })
    void pipeOfAModelIsToldAndLeftOut(String command, String pipe, String part) throws Exception {
        Pipe.at(folder.resolve(pipe));
        Ran ran = lab(command);
        assertNoted(ran, "is a device, pipe or socket, not a ");
        assertNoted(ran, part);
    }

    /** A link to itself is there, and yet not found: as where the folder is locked. */
    @ParameterizedTest(name = "{1} is called missing by {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "render FOLDER/of-pipe.obj | pipe.mtl | material file 'pipe.mtl' was passed over: Too",
                "render FOLDER/pictured.obj | pipe.png | one.mtl:2: texture 'pipe.png' cannot be read",
            })
    void linkToItselfIsToldAndLeftOut(String command, String link, String part) throws IOException {
        Files.createSymbolicLink(folder.resolve(link), folder.resolve(link));
        assertNoted(lab(command), part);
    }

    @ParameterizedTest(name = "{1} is called missing by {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "render FOLDER/one.scene.json | pipe.png | $.look.textureImage: texture 'pipe.png' cannot",
            })
    void linkToItselfIsNotMissing(String command, String link, String part) throws IOException {
        Files.createSymbolicLink(folder.resolve(link), folder.resolve(link));
        assertComplaint(lab(command), part);
    }

    /** The test is skipped for a user who may read everything. */
    @Test
    @DisplayName("a texture in a locked folder is called missing")
    void saysThatAFolderIsLocked() throws IOException {
        Path locked = Files.createDirectory(folder.resolve("locked"));
        Files.createFile(locked.resolve("pipe.png"));
        Files.writeString(folder.resolve("one.mtl"), "newmtl one\nmap_Kd locked/pipe.png\n");
        assumeTrue(Files.getFileStore(locked).supportsFileAttributeView("posix"));
        Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("---------"));
        try {
            assumeFalse(Files.isReadable(locked), "this user may read everything");
            assertNoted(
                    lab("render FOLDER/pictured.obj"),
                    "one.mtl:2: texture 'locked/pipe.png' cannot be read: no right to");
        } finally {
            Files.setPosixFilePermissions(locked, PosixFilePermissions.fromString("rwx------"));
        }
    }

    private Ran lab(String command) {
        boolean draws = command.startsWith("render") || command.startsWith("opengl");
        String out = draws ? " --out FOLDER/out.png" : "";
        return Ran.lab((command + out).replace("FOLDER", folder.toString()).split(" "));
    }

    private static void assertNoted(Ran ran, String part) {
        assertTrue(ran.err().contains(part), ran.err());
        assertEquals(0, ran.exitCode(), ran.err());
    }

    private static void assertComplaint(Ran ran, String part) {
        assertTrue(ran.err().contains(part), ran.err());
        assertEquals(1, ran.err().lines().count(), ran.err());
        assertEquals(2, ran.exitCode(), ran.err());
    }
}
