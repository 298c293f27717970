package rasterlab.exercises.runner.process;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The processor time of a process and of all that it started. */
final class ProcessorTime {
    private final Process process;
    private final boolean boxed;
    private List<ProcessHandle> all = List.of();

    /**
     * @param boxed whether the process is a box, in which the child proper is another
     */
    ProcessorTime(Process process, boolean boxed) {
        this.process = process;
        this.boxed = boxed;
    }

    /** The processor time used; empty where the system does not tell. */
    Optional<Duration> used() {
        return processes().stream()
                .map(one -> one.info().totalCpuDuration())
                .reduce(Optional.empty(), ProcessorTime::sum);
    }

    private static Optional<Duration> sum(Optional<Duration> one, Optional<Duration> other) {
        return Stream.of(one, other).flatMap(Optional::stream).reduce(Duration::plus);
    }

    /** A box starts another process, and that one the child; then none come any more. */
    private List<ProcessHandle> processes() {
        if (all.size() > (boxed ? 2 : 0)) return all;
        all = Stream.concat(Stream.of(process.toHandle()), process.descendants()).toList();
        return all;
    }
}
