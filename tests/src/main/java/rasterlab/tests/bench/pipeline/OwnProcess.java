package rasterlab.tests.bench.pipeline;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import rasterlab.tests.process.JavaCommand;

/**
 * A program with this one's Java, classes and options in a process of its own, which ends with this
 * one unless this one is killed. Runs once.
 */
final class OwnProcess {
    static final int LIMIT_MINUTES = 10;

    /** The code that {@link #run} returns for a process that had to be ended. */
    static final int TOO_LONG = -1;

    /** A debugger or profiler is for one process. */
    private static final List<String> NOT_SHARED = List.of("-agent", "-javaagent", "-Xrun");

    /** Java adds what they hold to its options, which are passed on already. */
    private static final List<String> VARIABLES =
            List.of("JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "_JAVA_OPTIONS");

    private final ProcessBuilder builder;
    private final Thread abandoner = new Thread(this::abandon, "end the process");
    private final Path printed;
    private final Path complained;
    private volatile Process process;
    private volatile boolean abandoned;

    /**
     * @param more options of Java's own after those of this process
     * @param program has a main method
     * @throws IOException if there is no place for what it prints
     */
    OwnProcess(List<String> more, Class<?> program, List<String> arguments) throws IOException {
        var options = new ArrayList<String>();
        for (String option : ManagementFactory.getRuntimeMXBean().getInputArguments())
            if (NOT_SHARED.stream().noneMatch(option::startsWith)) options.add(option);
        options.addAll(List.of("-Dstdout.encoding=UTF-8", "-Dstderr.encoding=UTF-8"));
        options.addAll(more);
        printed = Files.createTempFile("rasterlab", ".out");
        complained = Files.createTempFile("rasterlab", ".err");
        builder =
                new ProcessBuilder(JavaCommand.of(options, program.getName(), arguments))
                        .redirectOutput(printed.toFile())
                        .redirectError(complained.toFile());
        builder.environment().keySet().removeAll(VARIABLES);
    }

    /**
     * Runs it to its end and hands on what it printed and complained of.
     *
     * @return its exit code, or {@link #TOO_LONG} after {@value #LIMIT_MINUTES} minutes
     * @throws IOException if it cannot be started or what it printed cannot be read
     */
    int run(PrintStream out, PrintStream err) throws IOException, InterruptedException {
        remember();
        try {
            process = builder.start();
            if (abandoned) abandon();
            boolean ended = process.waitFor(LIMIT_MINUTES, TimeUnit.MINUTES);
            handOn(printed, out);
            handOn(complained, err);
            return ended ? process.exitValue() : TOO_LONG;
        } finally {
            forget();
            abandon();
        }
    }

    private void remember() {
        try {
            Runtime.getRuntime().addShutdownHook(abandoner);
        } catch (IllegalStateException ending) {
            abandon();
            awaitEnd();
        }
    }

    private void forget() {
        try {
            Runtime.getRuntime().removeShutdownHook(abandoner);
        } catch (IllegalStateException ending) {
            awaitEnd();
        }
    }

    /** This program is ending: nothing more is to be measured. */
    private static void awaitEnd() {
        while (true) LockSupport.park();
    }

    private void abandon() {
        abandoned = true;
        Process started = process;
        if (started != null) started.destroyForcibly().onExit().join();
        try {
            Files.deleteIfExists(printed);
            Files.deleteIfExists(complained);
        } catch (IOException e) {
            throw new UncheckedIOException("what a process printed stays behind", e);
        }
    }

    private static void handOn(Path file, PrintStream to) throws IOException {
        new String(Files.readAllBytes(file), StandardCharsets.UTF_8).lines().forEach(to::println);
        to.flush();
    }
}
