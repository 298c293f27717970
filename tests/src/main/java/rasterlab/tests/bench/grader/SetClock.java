package rasterlab.tests.bench.grader;

import static java.nio.file.StandardCopyOption.ATOMIC_MOVE;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A clock that is set by some hours and back, for one server: Debian's libfaketime shows it another
 * time than this machine's, but lets the time that passes be.
 */
final class SetClock implements ServerFault, AutoCloseable {
    private static final Path LIBRARIES = Path.of("/usr/lib");
    private static final String LIBRARY = "faketime/libfaketimeMT.so.1";
    private static final int HOUR = 3_600;
    private static final String TOLD = "the system's clock was set by";
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(20);
    private static final long PAUSE_MILLIS = 50;

    private final Path data;
    private final Path stamp;
    private final Path library;
    private final int hours;
    private long pid;

    private SetClock(Path folder, Path library, int hours) {
        data = folder.resolve("course");
        stamp = folder.resolve("clock");
        this.library = library;
        this.hours = hours;
    }

    /**
     * @param folder in which the data folder will be
     * @param hours by which it is set ahead, or back where they are negative
     * @throws NotMeasured where libfaketime is not installed
     */
    static SetClock in(Path folder, int hours) throws IOException, NotMeasured {
        Optional<Path> library = library();
        if (library.isEmpty())
            throw new NotMeasured("grader.missing.faketime", LIBRARIES + "/*/" + LIBRARY);
        var clock = new SetClock(folder, library.get(), hours);
        clock.show(0);
        return clock;
    }

    private static Optional<Path> library() throws IOException {
        try (Stream<Path> machines = Files.list(LIBRARIES)) {
            return machines.map(machine -> machine.resolve(LIBRARY))
                    .filter(Files::isRegularFile)
                    .findFirst();
        }
    }

    @Override
    public Path data() {
        return data;
    }

    @Override
    public LabCall of(LabCall plain) {
        return plain.withVariables(
                Map.of(
                        "LD_PRELOAD",
                        library.toString(),
                        "FAKETIME_TIMESTAMP_FILE",
                        stamp.toString(),
                        // the file is read once a second, not at each look at the clock
                        "FAKETIME_CACHE_DURATION",
                        "1",
                        "FAKETIME_DONT_FAKE_MONOTONIC",
                        "1",
                        // waiting by the other clock is no busy waiting
                        "FAKETIME_FORCE_MONOTONIC_FIX",
                        "0",
                        // times of files stay what they are
                        "NO_FAKE_STAT",
                        "1"));
    }

    /** The server's log has to say that it saw it. */
    @Override
    public void begin(BenchServer server) throws IOException, InterruptedException, NotMeasured {
        pid = server.pid();
        show(hours * HOUR);
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!isTold()) {
            if (System.nanoTime() > end) throw new NotMeasured("grader.missing.clock", TOLD);
            TimeUnit.MILLISECONDS.sleep(PAUSE_MILLIS);
        }
    }

    private boolean isTold() throws IOException {
        List<String> log = Files.readAllLines(data.resolve("server.log"));
        return log.stream().anyMatch(line -> line.contains(TOLD));
    }

    @Override
    public void end() throws IOException {
        show(0);
    }

    /** Removes the shared memory that libfaketime leaves behind. */
    @Override
    public void close() throws IOException {
        for (String name : List.of("faketime_shm_", "sem.faketime_sem_"))
            Files.deleteIfExists(Path.of("/dev/shm", name + pid));
    }

    /** Replaces the file at once: a process that reads it never finds it half written. */
    private void show(int secondsAhead) throws IOException {
        Path next = stamp.resolveSibling("clock-to-be");
        Files.writeString(next, "%+d\n".formatted(secondsAhead));
        Files.move(next, stamp, ATOMIC_MOVE);
    }
}
