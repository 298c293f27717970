package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@Tag("slow")
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "a POSIX shell stands in for the server")
class GraderProcessTest {
    @TempDir Path home;

    /** Says what a server says, has data, and tidies up when it is asked to stop. */
    @BeforeEach
    void standIn() throws Exception {
        script(
                "lab",
                """
                #!/bin/sh
                cd "$(dirname "$0")"
                for data; do :; done
                echo "$data" >data
                echo grades >"$data/grades"
                : >children
                trap 'rm children; exit' TERM
                echo 'listening on http://127.0.0.1:1'
                while :; do sleep 0.05; done
                """);
    }

    private void script(String name, String text) throws Exception {
        Path script = home.resolve(name);
        Files.writeString(script, text);
        Files.setPosixFilePermissions(script, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    @Test
    void programThatEndsFirstLeavesNothingOfTheServer() throws Exception {
        var server = GraderProcess.start(home, line -> {});
        assertEquals(URI.create("http://127.0.0.1:1"), server.address());
        assertTrue(Files.exists(data().resolve("grades")));
        server.abandon();
        assertNothingIsLeft();
        server.close();
    }

    @Test
    void closingLeavesNothingOfTheServer() throws Exception {
        var server = GraderProcess.start(home, line -> {});
        server.address();
        server.close();
        assertNothingIsLeft();
    }

    @Test
    void closingAwaitsTheServerThatTheScriptStartedAsItsChild() throws Exception {
        Files.move(home.resolve("lab"), home.resolve("server"));
        script("lab", "#!/bin/sh\n\"$(dirname \"$0\")/server\" \"$@\"\n");
        closingLeavesNothingOfTheServer();
    }

    private Path data() throws Exception {
        return Path.of(Files.readString(home.resolve("data")).strip());
    }

    private void assertNothingIsLeft() throws Exception {
        assertFalse(Files.exists(data()), "the data folder stays");
        assertFalse(Files.exists(home.resolve("children")), "the server could not tidy up");
    }
}
