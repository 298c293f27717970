package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * The processor time of a child, which is asked for before and after each call: where the system
 * keeps it in a file, that one file is read.
 */
final class ProcessorTime {
    /**
     * Linux counts for programs in hundredths of a second, whatever its own clock does: proc(5).
     */
    private static final int NANOS_PER_TICK = 10_000_000;

    /** Fields behind the name in brackets, of which the first is the third of all: proc(5). */
    private static final int USER_TIME = 14 - 3;

    private static final int SYSTEM_TIME = 15 - 3;

    private final Process process;
    private final boolean boxed;
    private Optional<ProcessHandle> child = Optional.empty();

    /**
     * @param boxed whether the process is a box, in which the child proper is another
     */
    ProcessorTime(Process process, boolean boxed) {
        this.process = process;
        this.boxed = boxed;
    }

    /** The processor time used; empty where the system does not tell. */
    Optional<Duration> used() {
        if (child.isEmpty()) child = innermost();
        ProcessHandle counted = child.orElseGet(process::toHandle);
        return told(counted.pid()).or(() -> counted.info().totalCpuDuration());
    }

    /** The time that the system's file of a process tells; empty where there is none. */
    private static Optional<Duration> told(long pid) {
        try {
            Path file = Path.of("/proc", String.valueOf(pid), "stat");
            return Optional.of(ofLine(Files.readString(file, StandardCharsets.ISO_8859_1)));
        } catch (IOException | NumberFormatException | IndexOutOfBoundsException untold) {
            return Optional.empty();
        }
    }

    /**
     * The time of a process in user mode and in the system.
     *
     * @param stat the line of proc(5), in which the name may have blanks and brackets
     */
    static Duration ofLine(String stat) {
        String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
        long ticks = Long.parseLong(fields[USER_TIME]) + Long.parseLong(fields[SYSTEM_TIME]);
        return Duration.ofNanos(ticks * NANOS_PER_TICK);
    }

    /** A box starts another process, and that one the child; empty while they are to come. */
    private Optional<ProcessHandle> innermost() {
        if (!boxed) return Optional.of(process.toHandle());
        List<ProcessHandle> below = process.descendants().toList();
        if (below.size() < 2) return Optional.empty();
        List<Long> parents =
                below.stream()
                        .map(ProcessHandle::parent)
                        .flatMap(Optional::stream)
                        .map(ProcessHandle::pid)
                        .toList();
        return below.stream().filter(one -> !parents.contains(one.pid())).findFirst();
    }
}
