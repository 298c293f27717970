package rasterlab.exercises.runner.process;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Programs of this machine that children are started with. */
public final class Programs {
    /**
     * The limit for all processes and threads of the account: beyond what a server with 64 workers
     * and a person's session need, and far below what a machine can bear.
     */
    public static final int MOST_PROCESSES = 4096;

    static final int MOST_FILES = 256;
    static final int MOST_SECONDS = 30;

    /** The steps that a process goes down which can wait; each takes about a fifth of its share. */
    public static final int STEPS_DOWN = 10;

    private Programs() {}

    /** The folder of the running JDK without symbolic links. */
    public static Path javaHome() {
        try {
            return Path.of(System.getProperty("java.home")).toRealPath();
        } catch (IOException e) {
            throw new UncheckedIOException("java.home is no folder", e);
        }
    }

    public static String java() {
        return ofJava("java").toString();
    }

    /** A program of the running JDK, which may not have it. */
    static Path ofJava(String name) {
        return in(javaHome(), name);
    }

    /** A program of the Java with that home folder. */
    public static Path in(Path javaHome, String name) {
        boolean windows = File.separatorChar == '\\';
        return javaHome.resolve("bin").resolve(windows ? name + ".exe" : name);
    }

    public static Optional<String> onPath(String name) {
        String path = System.getenv("PATH");
        return Stream.of(path == null ? new String[0] : path.split(File.pathSeparator))
                .filter(folder -> !folder.isEmpty())
                .map(folder -> Path.of(folder, name))
                .filter(Path::isAbsolute)
                .filter(Files::isExecutable)
                .map(Path::toString)
                .findFirst();
    }

    /**
     * The beginning of a command that gets processor time after others. Empty where there is no
     * nice.
     */
    static List<String> afterOthers() {
        return onPath("nice")
                .map(program -> List.of(program, "-n", "" + STEPS_DOWN))
                .orElseGet(List::of);
    }

    /**
     * The beginning of a command that sets what the kernel limits for each process: no core dump,
     * no file written, few files open, half a minute of processor time. Empty where there is no
     * prlimit.
     *
     * @param processes whether the number of processes is limited too
     */
    public static List<String> limits(boolean processes) {
        List<String> command = new ArrayList<>();
        onPath("prlimit")
                .ifPresent(
                        program -> {
                            command.add(program);
                            command.addAll(
                                    List.of(
                                            "--core=0",
                                            "--fsize=0",
                                            "--nofile=" + MOST_FILES,
                                            "--cpu=" + MOST_SECONDS));
                            if (processes) command.add("--nproc=" + MOST_PROCESSES);
                            command.add("--");
                        });
        return command;
    }
}
