package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.Programs;

/** A bubblewrap that does not work is told with its true reason and holds nobody up. */
@DisabledOnOs(OS.WINDOWS)
class BoxChoiceTest {
    @TempDir private Path folder;

    static Stream<Arguments> programs() {
        return Stream.of(
                argumentSet(
                        "a program that hangs is waited for without end",
                        "#!/bin/sh\nread line\n",
                        Duration.ofMillis(200),
                        "does not work here: --help gave no answer within 0.2 s"),
                argumentSet(
                        "a program that cannot be started counts as an old one",
                        "#!/no/such/interpreter\n",
                        Duration.ofMinutes(1),
                        "does not work here: Cannot run program"),
                argumentSet(
                        "an old program is used",
                        "#!/bin/sh\necho --tmpfs\n",
                        Duration.ofMinutes(1),
                        "older than 0.7"));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("programs")
    void saysWhyThereIsNoBubblewrap(String script, Duration limit, String said) throws Exception {
        Path program = folder.resolve("bwrap");
        Files.writeString(program, script);
        Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwx------"));
        try (ChildJars jars = ChildJars.assemble();
                Launcher launcher = new Launcher(jars)) {
            BoxChoice choice = new BoxChoice(launcher, jars, ChildJava.running(), limit);
            Box box = choice.inBubblewrap(program.toString());
            assertEquals("process limits only", box.isolation().name());
            assertTrue(
                    box.isolation().describe("en").contains(said),
                    () -> box.isolation().describe("en"));
        }
    }

    @Test
    @DisplayName("a judge that cannot start leaves its folder behind")
    void aJudgeThatCannotStartLeavesNothing() throws IOException {
        assumeTrue(Programs.onPath("bwrap").isPresent(), "bubblewrap is missing");
        long before = folders();
        Thread.currentThread().interrupt();
        assertThrows(
                IllegalStateException.class, () -> Judge.start(JudgeSettings.defaults()).close());
        assertTrue(Thread.interrupted(), "the interrupt is kept");
        assertEquals(before, folders());
    }

    private static long folders() throws IOException {
        try (Stream<Path> files = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
            String own = "-" + ProcessHandle.current().pid() + "-";
            return files.filter(file -> file.getFileName().toString().contains(own)).count();
        }
    }
}
