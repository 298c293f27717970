package rasterlab.exercises.runner;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildJars;
import rasterlab.exercises.runner.process.ControlGroup;
import rasterlab.exercises.runner.process.ControlGroups.FoundGroups;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.Programs;
import rasterlab.exercises.score.Message;

/**
 * Linux namespaces by bubblewrap: the child sees a read-only root that holds its Java, the system
 * libraries and two jars; no network, no other process, not even its own in /proc, because none is
 * mounted.
 */
final class BubblewrapBox implements Box {
    private static final String HARNESS = "/box/harness.jar";
    private static final String CONTRACT = "/box/contract.jar";
    private static final Path IMAGE = Path.of("/java");
    private static final String SHELL = "/bin/sh";
    private static final String FILTER_DESCRIPTOR = "9";
    private static final String OPEN_AND_RUN = "exec \"$@\" " + FILTER_DESCRIPTOR + "<\"$0\"";
    private static final List<String> LIBRARIES =
            List.of("/lib64", "/usr/lib64", "/lib", "/usr/lib");

    private final String program;
    private final boolean canDisableUserNamespaces;
    private final Isolation.ProcessLimit limit;
    private final boolean filtered;
    private final ChildJars jars;
    private final ChildJava java;
    private final FoundGroups groups;
    private final Isolation isolation;

    /**
     * @param program path of bwrap
     * @param version as bwrap prints it
     * @param canDisableUserNamespaces whether it knows --disable-userns (0.8 and later)
     * @param limit on the number of processes; set unless it would be too low
     * @param filtered whether the kernel filters the system calls
     * @param faults what was found not to hold
     * @param groups in which children run; none where they run in this process's own
     */
    BubblewrapBox(
            String program,
            String version,
            boolean canDisableUserNamespaces,
            Isolation.ProcessLimit limit,
            boolean filtered,
            List<Message> faults,
            ChildJars jars,
            ChildJava java,
            FoundGroups groups) {
        this.limit = limit;
        this.filtered = filtered;
        this.program = program;
        this.canDisableUserNamespaces = canDisableUserNamespaces;
        this.jars = jars;
        this.java = java;
        this.groups = groups;
        List<Message> lacking = new ArrayList<>();
        for (Message one : List.of(java.lacking(), groups.lacking()))
            if (!one.isEmpty()) lacking.add(one);
        lacking.addAll(faults);
        this.isolation = Isolation.bubblewrap(version, limit, java.isImage(), lacking);
    }

    @Override
    public Isolation isolation() {
        return isolation;
    }

    /** The limit on the number of processes that it sets. */
    Isolation.ProcessLimit limit() {
        return limit;
    }

    boolean isFiltered() {
        return filtered;
    }

    @Override
    public boolean nested() {
        return true;
    }

    @Override
    public Child start(Launcher launcher, ChildKind kind, boolean warm) {
        if (groups.groups().isEmpty()) return Box.super.start(launcher, kind, warm);
        ControlGroup group;
        try {
            group = groups.groups().get().make(kind.group());
        } catch (IOException e) {
            throw new UncheckedIOException("cannot make a control group", e);
        }
        try {
            Process process = launcher.start(group.joined(command(kind, warm)));
            return new Child(process, true, Optional.of(group));
        } catch (RuntimeException e) {
            group.end();
            throw e;
        }
    }

    @Override
    public List<String> command(ChildKind kind, boolean warm) {
        List<String> command = new ArrayList<>();
        // the shell only opens the filter's file: nothing of a submission is in its words
        if (filtered) command.addAll(List.of(SHELL, "-c", OPEN_AND_RUN, jars.filter().toString()));
        command.addAll(Programs.limits(limit != Isolation.ProcessLimit.TOO_LOW));
        command.add(program);
        command.addAll(List.of("--unshare-all", "--unshare-user", "--uid", "65534"));
        command.addAll(List.of("--gid", "65534", "--hostname", "box"));
        if (canDisableUserNamespaces) command.add("--disable-userns");
        command.addAll(List.of("--die-with-parent", "--new-session", "--cap-drop", "ALL"));
        if (filtered) command.addAll(List.of("--seccomp", FILTER_DESCRIPTOR));
        command.add("--clearenv");
        // without /proc the loader cannot ask where java lies, and would not find its libraries
        Path home = java.isImage() ? IMAGE : java.home(kind);
        command.addAll(List.of("--setenv", "LD_ORIGIN_PATH", home.resolve("bin").toString()));
        command.addAll(root(kind, home));
        command.addAll(List.of("--chdir", "/", "--", Programs.in(home, "java").toString()));
        command.addAll(kind.arguments(HARNESS, CONTRACT, warm));
        return command;
    }

    /**
     * @param home where the child finds its Java
     */
    private List<String> root(ChildKind kind, Path home) {
        List<String> root = new ArrayList<>();
        libraries().forEach(folder -> bind(root, folder.toString(), folder.toString()));
        bind(root, java.home(kind).toString(), home.toString());
        if (!java.isImage())
            linkedOut().forEach(file -> bind(root, file.toString(), file.toString()));
        bind(root, jars.harness().toString(), HARNESS);
        bind(root, jars.contract().toString(), CONTRACT);
        // a fresh /dev has a writable /dev/shm without a limit, and new folders stay writable
        root.addAll(List.of("--dev", "/dev", "--size", "65536", "--tmpfs", "/dev/shm"));
        root.addAll(List.of("--remount-ro", "/dev/shm", "--remount-ro", "/dev"));
        root.addAll(List.of("--remount-ro", "/"));
        return root;
    }

    private static void bind(List<String> root, String from, String to) {
        root.addAll(List.of("--ro-bind", from, to));
    }

    /**
     * The loader's folder, and of /lib and /usr/lib the part for this machine where there is one.
     */
    private static List<Path> libraries() {
        List<Path> folders = new ArrayList<>();
        for (String name : LIBRARIES) {
            Path folder = Path.of(name);
            if (!Files.isDirectory(folder)) continue;
            List<Path> parts = name.endsWith("64") ? List.of() : machineParts(folder);
            folders.addAll(parts.isEmpty() ? List.of(folder) : parts);
        }
        return folders;
    }

    private static List<Path> machineParts(Path folder) {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.filter(entry -> entry.getFileName().toString().matches(".+-linux-.+"))
                    .filter(Files::isDirectory)
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot list " + folder, e);
        }
    }

    /** Files of the JDK that a distribution keeps elsewhere, such as Debian below /etc. */
    private static List<Path> linkedOut() {
        Path home = Programs.javaHome();
        return Stream.of("lib/jvm.cfg", "conf/security/java.security", "lib/security/cacerts")
                .map(home::resolve)
                .filter(Files::exists)
                .map(BubblewrapBox::real)
                .filter(file -> !file.startsWith(home))
                .toList();
    }

    private static Path real(Path file) {
        try {
            return file.toRealPath();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot follow " + file, e);
        }
    }
}
