package rasterlab.exercises.runner;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.runner.child.Wire;

/** Finds the strongest box that works on this machine by trying it once. */
final class BoxChoice {
    private static final Duration SELF_TEST_LIMIT = Duration.ofSeconds(10);

    private final Launcher launcher;
    private final ChildJars jars;

    BoxChoice(Launcher launcher, ChildJars jars) {
        this.launcher = launcher;
        this.jars = jars;
    }

    Box choose(JudgeSettings.Box wanted) {
        if (wanted == JudgeSettings.Box.PROCESS_LIMITS_ONLY)
            return new PlainBox(jars, "bubblewrap was not asked for");
        Optional<String> program = Programs.onPath("bwrap");
        if (program.isEmpty()) return new PlainBox(jars, "bwrap is not on the PATH");
        String help = output(List.of(program.get(), "--help"));
        if (!help.contains("--size"))
            return new PlainBox(jars, "bwrap is older than 0.7: it cannot size a tmpfs");
        Box box =
                new BubblewrapBox(
                        program.get(),
                        output(List.of(program.get(), "--version")),
                        help.contains("--disable-userns"),
                        jars);
        return selfTest(box)
                .<Box>map(reason -> new PlainBox(jars, "bwrap does not work here: " + reason))
                .orElse(box);
    }

    /** Why a child in the box does not answer; empty when it does. */
    private Optional<String> selfTest(Box box) {
        try (Child child = new Child(launcher.start(box.command(ChildKind.RUN, false)))) {
            try {
                child.ask(
                        new Request(Wire.PING, out -> {}),
                        SELF_TEST_LIMIT,
                        (status, payload) -> status);
                return Optional.empty();
            } catch (ChildLost lost) {
                return Optional.of(
                        child.complaint().isEmpty()
                                ? lost.getMessage()
                                : child.complaint().lines().findFirst().orElseThrow());
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                throw new IllegalStateException("interrupted while trying bubblewrap", e);
            }
        }
    }

    private String output(List<String> command) {
        Process process = launcher.start(command);
        try (var in = process.getInputStream()) {
            return new String(in.readNBytes(1 << 16), StandardCharsets.UTF_8).strip();
        } catch (IOException e) {
            return "";
        } finally {
            process.destroyForcibly();
        }
    }
}
