package rasterlab.tests.bench.grader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.bench.language.BenchWords;

class BenchFolderTest {
    @Test
    @DisplayName("of a server that failed the log is removed with its data")
    void keepsTheLogsOfWhatFails() throws IOException {
        BenchFolder folder = BenchFolder.make();
        LoggedFailure failed;
        try (folder) {
            Path data = Files.createDirectories(folder.path().resolve("course"));
            Files.writeString(data.resolve("server.log"), "it ends");
            Files.writeString(data.resolve("rasterlab.db"), "data");
            Files.writeString(folder.errors("server"), "why");
            failed =
                    assertThrows(
                            LoggedFailure.class,
                            () ->
                                    folder.keepingLogs(
                                            () -> {
                                                throw new IOException("it does not\n answer");
                                            }));
        }
        assertFalse(Files.exists(folder.path()));
        try (var copies = new BenchFolder(Path.of(failed.logs()));
                Stream<Path> files = Files.list(copies.path())) {
            assertEquals("it ends", Files.readString(copies.path().resolve("course-server.log")));
            assertEquals("why", Files.readString(copies.path().resolve("server.errors")));
            assertEquals(2, files.count());
        }
        assertEquals(
                "./lab bench: disk failed: it does not answer; the logs of its servers are in "
                        + failed.logs(),
                GraderBench.sentence("disk", failed, BenchWords.ENGLISH));
    }

    @Test
    @DisplayName("a failure without a word is told as null, one without a server with its logs")
    void saysWhatFailsWithoutAServer() {
        assertEquals(
                "./lab bench: single failed: java.io.IOException",
                GraderBench.sentence("single", new IOException(), BenchWords.ENGLISH));
    }
}
