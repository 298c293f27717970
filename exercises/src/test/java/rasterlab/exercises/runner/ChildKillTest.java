package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.Programs;

/**
 * A child is killed at any moment of its start. In a box it is three processes, and the second,
 * started last, must not be left behind by the first.
 */
@Tag("slow")
class ChildKillTest {
    private static final int STARTS = Boolean.getBoolean("rasterlab.full") ? 2_000 : 100;

    /** The time within which the box has begun and the child's Java machine runs. */
    private static final Duration LATEST = Duration.ofMillis(20);

    @Test
    void nothingIsLeftOfAChildKilledWhileItStarts() throws Exception {
        assumeTrue(Programs.onPath("bwrap").isPresent(), "bubblewrap is missing");
        long seed = new Random().nextLong();
        var moments = new Random(seed);
        try (var unscanned = new Unscanned(JudgeSettings.Protection.STRONGEST)) {
            assumeTrue(unscanned.box.isolation().name().equals("bubblewrap"), "it does not work");
            for (int i = 0; i < STARTS; i++) {
                long wait = moments.nextLong(LATEST.toNanos());
                long start = System.nanoTime();
                Child child = unscanned.child(ChildKind.RUN);
                while (System.nanoTime() - start < wait) Thread.onSpinWait();
                child.close();
                String when = "seed " + seed + ", start " + i + ", killed after " + wait + " ns";
                assertEquals(List.of(), leftOf(unscanned.jars), when);
            }
        }
    }

    /** Processes with that folder in their command, whoever is their parent now. */
    private static List<String> leftOf(ChildJars jars) {
        var left = new ArrayList<String>();
        for (ProcessHandle one : ProcessHandle.allProcesses().toList()) {
            String command = command(one);
            if (command.contains(jars.folder().toString()))
                left.add(one.pid() + " " + command.split("\0")[0]);
        }
        return left;
    }

    /** The command of a process; empty where it has ended or another account's hides it. */
    private static String command(ProcessHandle process) {
        try {
            return Files.readString(Path.of("/proc/" + process.pid() + "/cmdline"));
        } catch (IOException gone) {
            return "";
        }
    }
}
