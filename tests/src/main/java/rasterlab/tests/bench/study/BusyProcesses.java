package rasterlab.tests.bench.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.tests.process.JavaCommand;

/** Processes that keep the machine busy until they are closed or this one ends. */
final class BusyProcesses implements AutoCloseable {
    private static final List<String> OPTIONS =
            List.of("-Xmx16m", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

    private final List<Process> processes = new ArrayList<>();

    /** Starts that many. */
    BusyProcesses(int count) throws IOException {
        for (int i = 0; i < count; i++)
            processes.add(
                    new ProcessBuilder(JavaCommand.of(OPTIONS, BusyLoop.class.getName(), List.of()))
                            .start());
        // each says a byte once it is at work
        for (Process one : processes) one.getInputStream().read();
    }

    /** How many of them are at work. */
    long running() {
        return processes.stream().filter(Process::isAlive).count();
    }

    @Override
    public void close() {
        processes.forEach(Process::destroyForcibly);
    }
}
