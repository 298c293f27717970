package rasterlab.tests.bench.pipeline;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import rasterlab.tests.bench.JavaCommand;

/**
 * A program with this one's Java, classes and options in a process of its own, which ends with this
 * one at the latest.
 */
final class OwnProcess {
    private static final int LIMIT_MINUTES = 10;
    private static final String WARNING = "WARNING: Using incubator modules";

    private final List<String> options = new ArrayList<>();
    private final Class<?> program;
    private final List<String> arguments;

    /**
     * @param more options of Java's own after those of this process
     * @param program has a main method
     */
    OwnProcess(List<String> more, Class<?> program, List<String> arguments) {
        for (String option : ManagementFactory.getRuntimeMXBean().getInputArguments())
            if (!isAgent(option)) options.add(option);
        options.addAll(more);
        this.program = program;
        this.arguments = arguments;
    }

    /** A debugger or profiler is for one process. */
    private static boolean isAgent(String option) {
        return option.startsWith("-agent") || option.startsWith("-javaagent");
    }

    /**
     * Runs it to its end and hands on what it printed and complained of, but for Java's warning of
     * the Vector API, which this process has given.
     *
     * @return whether it did its work; a process that takes longer than {@value #LIMIT_MINUTES}
     *     minutes is ended
     * @throws IOException if it cannot be started
     */
    boolean run(PrintStream out, PrintStream err) throws IOException, InterruptedException {
        Path printed = Files.createTempFile("rasterlab", ".out");
        Path complained = Files.createTempFile("rasterlab", ".err");
        printed.toFile().deleteOnExit();
        complained.toFile().deleteOnExit();
        try {
            boolean done = end(printed, complained);
            handOn(printed, out);
            handOn(complained, err);
            return done;
        } finally {
            Files.deleteIfExists(printed);
            Files.deleteIfExists(complained);
        }
    }

    private boolean end(Path printed, Path complained) throws IOException, InterruptedException {
        Process process =
                new ProcessBuilder(JavaCommand.of(options, program.getName(), arguments))
                        .redirectOutput(printed.toFile())
                        .redirectError(complained.toFile())
                        .start();
        var killer = new Thread(process::destroyForcibly);
        try {
            Runtime.getRuntime().addShutdownHook(killer);
            boolean ended = process.waitFor(LIMIT_MINUTES, TimeUnit.MINUTES);
            Runtime.getRuntime().removeShutdownHook(killer);
            return ended && process.exitValue() == 0;
        } finally {
            process.destroyForcibly().waitFor();
        }
    }

    private static void handOn(Path file, PrintStream to) throws IOException {
        new String(Files.readAllBytes(file), StandardCharsets.UTF_8)
                .lines()
                .filter(line -> !line.startsWith(WARNING))
                .forEach(to::println);
        to.flush();
    }
}
