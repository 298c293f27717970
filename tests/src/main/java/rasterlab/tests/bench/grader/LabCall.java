package rasterlab.tests.bench.grader;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.Stream;

/**
 * A call of {@code ./lab grader}.
 *
 * @param home folder of the program
 * @param environment what it gets beside that of this process
 * @param openFiles the most files that it may have open at the same time, where that is limited
 */
record LabCall(
        Path home, List<String> arguments, Map<String, String> environment, OptionalInt openFiles) {
    /** The images of Java that sources run on, which are made once for all processes. */
    static final Path IMAGES =
            Path.of(System.getProperty("java.io.tmpdir"), "rasterlab-bench-images");

    LabCall {
        arguments = List.copyOf(arguments);
        environment = Map.copyOf(environment);
    }

    /** The call of a server that limits nobody but by its own strength. */
    static LabCall serve(Path home, Path data) {
        return of(home, "serve", data)
                .with("--port", "0", "--entries-per-minute", "100000")
                .with("--submissions-per-minute", "100000", "--waiting", "100000");
    }

    /** The call of a process that grades what servers take in. */
    static LabCall worker(Path home, Path data) {
        return of(home, "worker", data);
    }

    private static LabCall of(Path home, String command, Path data) {
        return new LabCall(home, List.of(command), Map.of(), OptionalInt.empty())
                .with("--data", data.toString(), "--java-images", IMAGES.toString());
    }

    LabCall with(String... more) {
        List<String> all = Stream.concat(arguments.stream(), Stream.of(more)).toList();
        return new LabCall(home, all, environment, openFiles);
    }

    LabCall withVariables(Map<String, String> more) {
        var all = new HashMap<>(environment);
        all.putAll(more);
        return new LabCall(home, arguments, all, openFiles);
    }

    /** Limits the process itself; the children that grade take as many files as the machine has. */
    LabCall withFiles(int most) {
        LabCall limited = new LabCall(home, arguments, environment, OptionalInt.of(most));
        // otherwise Java takes as many as it may
        return limited.withVariables(Map.of("JDK_JAVA_OPTIONS", "-XX:-MaxFDLimit"));
    }

    ProcessBuilder process() {
        var command = new ArrayList<String>();
        openFiles.ifPresent(
                most ->
                        command.addAll(
                                List.of(
                                        "sh",
                                        "-c",
                                        "ulimit -Sn \"$0\" && exec \"$@\"",
                                        String.valueOf(most))));
        command.addAll(List.of(home.resolve("lab").toString(), "grader"));
        command.addAll(arguments);
        var builder = new ProcessBuilder(command);
        builder.environment().putAll(environment);
        return builder;
    }
}
