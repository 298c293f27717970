package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.exercises.runner.process.Programs;

/** A child whose parent was killed is ended by nothing of the system's without a box. */
@Tag("slow")
class OrphanTest {
    @TempDir private Path folder;

    @Test
    @DisplayName("a child that is at something endless outlives its killed parent")
    void aChildEndsWithItsParent() throws Exception {
        Process parent =
                new ProcessBuilder(
                                Programs.java(),
                                "-cp",
                                System.getProperty("java.class.path"),
                                ChildWithParent.class.getName(),
                                folder.resolve("begun").toString())
                        .redirectError(ProcessBuilder.Redirect.INHERIT)
                        .start();
        Optional<ProcessHandle> child = Optional.empty();
        try {
            long pid = Long.parseLong(parent.inputReader().readLine());
            child = ProcessHandle.of(pid);
            CompletableFuture<ProcessHandle> ended = child.orElseThrow().onExit();
            parent.destroyForcibly();
            assertTrue(parent.waitFor(2, TimeUnit.MINUTES), "the parent is not killed");
            assertDoesNotThrow(() -> ended.get(2, TimeUnit.MINUTES), "the child lives on");
        } finally {
            parent.descendants().forEach(ProcessHandle::destroyForcibly);
            parent.destroyForcibly();
            child.ifPresent(ProcessHandle::destroyForcibly);
        }
    }
}
