package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Stream;
import rasterlab.exercises.score.Message;

/**
 * Makes control groups, by which the kernel limits memory, processes and processor time of a child
 * as a whole. They lie below the group of this process, which has to have that group to itself and
 * to be allowed to change it; it moves into a group of its own there, since only a group without
 * processes may limit others.
 *
 * <p>Source: Linux, Documentation/admin-guide/cgroup-v2.rst.
 */
public final class ControlGroups {
    static final String OWN = "rasterlab-server";
    private static final String CHILD = "rasterlab-child-";
    private static final List<String> CONTROLLERS = List.of("memory", "pids", "cpu");
    private static final AtomicLong NUMBERS = new AtomicLong();

    private final Path folder;

    private ControlGroups(Path folder) {
        this.folder = folder;
    }

    /**
     * Limits of a group.
     *
     * @param bytes of memory, the kernel's for it included
     * @param processes and threads, at the same time
     * @param cores of processor time, at each moment
     */
    public record GroupLimits(long bytes, int processes, int cores) {
        private static final int PERIOD_MICROS = 100_000;

        String processorTime() {
            return (long) cores * PERIOD_MICROS + " " + PERIOD_MICROS;
        }
    }

    /**
     * The control groups of this machine.
     *
     * @param groups empty where there are none
     * @param lacking why there are none
     */
    public record FoundGroups(Optional<ControlGroups> groups, Message lacking) {}

    /** The groups below this process's own. */
    public static FoundGroups find() {
        try {
            Optional<Path> own =
                    own(
                            Files.readAllLines(Path.of("/proc/self/mountinfo")),
                            Files.readAllLines(Path.of("/proc/self/cgroup")));
            return own.isPresent()
                    ? find(own.get(), ProcessHandle.current().pid())
                    : none("isolation.groups-none");
        } catch (IOException noLinux) {
            return none("isolation.groups-none");
        }
    }

    /**
     * The folder of the group of this process; empty where there is no hierarchy of version 2.
     *
     * @param mounts lines of /proc/self/mountinfo
     * @param groups lines of /proc/self/cgroup
     */
    static Optional<Path> own(List<String> mounts, List<String> groups) {
        Optional<String> group =
                groups.stream()
                        .filter(line -> line.startsWith("0::/"))
                        .map(line -> line.substring("0::/".length()))
                        .findFirst();
        return mounts.stream()
                .filter(line -> line.contains(" - cgroup2 "))
                .map(line -> line.split(" "))
                .filter(words -> words[3].equals("/"))
                .findFirst()
                .flatMap(words -> group.map(name -> Path.of(words[4], name)));
    }

    /**
     * @param own folder of the group of that process
     */
    static FoundGroups find(Path own, long process) {
        boolean moved = own.getFileName() != null && own.getFileName().toString().equals(OWN);
        Path folder = moved ? own.getParent() : own;
        try {
            List<String> there = words(folder.resolve("cgroup.controllers"));
            List<String> away = CONTROLLERS.stream().filter(one -> !there.contains(one)).toList();
            if (!away.isEmpty()) return none("isolation.groups-kinds", String.join(", ", away));
            List<String> processes = words(folder.resolve("cgroup.procs"));
            if (processes.stream().anyMatch(one -> !one.equals(Long.toString(process))))
                return none("isolation.groups-shared");
            if (!moved) move(folder, process);
            Files.writeString(
                    folder.resolve("cgroup.subtree_control"), "+" + String.join(" +", CONTROLLERS));
            removeLeftovers(folder, process);
            ControlGroups groups = new ControlGroups(folder);
            groups.make(new GroupLimits(1 << 20, 1, 1), process).end();
            return new FoundGroups(Optional.of(groups), Message.NONE);
        } catch (AccessDeniedException fixed) {
            return none("isolation.groups-fixed", fixed.getFile());
        } catch (IOException failed) {
            return none("isolation.groups-fail", said(failed));
        }
    }

    private static FoundGroups none(String key, Object... arguments) {
        return new FoundGroups(Optional.empty(), Message.of(key, arguments));
    }

    private static String said(IOException failed) {
        boolean named = failed instanceof FileSystemException;
        String reason = named ? ((FileSystemException) failed).getReason() : failed.getMessage();
        return reason == null ? failed.toString() : reason;
    }

    private static void move(Path folder, long process) throws IOException {
        Path leaf = folder.resolve(OWN);
        try {
            Files.createDirectory(leaf);
        } catch (FileAlreadyExistsException ofAnEarlierOne) {
            // it has no process: none of its processes is left in the folder but this one
        }
        Files.writeString(leaf.resolve("cgroup.procs"), Long.toString(process));
    }

    /** Groups of children of an earlier process, which was killed before it could remove them. */
    private static void removeLeftovers(Path folder, long process) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            for (Path one : all.toList()) {
                String name = one.getFileName().toString();
                if (name.startsWith(CHILD) && !name.startsWith(CHILD + process + "-"))
                    new ControlGroup(one).end();
            }
        }
    }

    /**
     * A new group without processes.
     *
     * @throws IOException when it cannot be made, or does not have the limits that were set
     */
    public ControlGroup make(GroupLimits limits) throws IOException {
        return make(limits, ProcessHandle.current().pid());
    }

    private ControlGroup make(GroupLimits limits, long process) throws IOException {
        Path made =
                Files.createDirectory(
                        folder.resolve(CHILD + process + "-" + NUMBERS.incrementAndGet()));
        ControlGroup group = new ControlGroup(made);
        try {
            group.limit("memory.max", Long.toString(limits.bytes()));
            group.limitWhereThere("memory.swap.max", "0");
            group.limitWhereThere("memory.oom.group", "1");
            group.limit("pids.max", Integer.toString(limits.processes()));
            group.limit("cpu.max", limits.processorTime());
            return group;
        } catch (IOException failed) {
            group.end();
            throw failed;
        }
    }

    static List<String> words(Path file) throws IOException {
        return Stream.of(Files.readString(file).strip().split("\\s+"))
                .filter(word -> !word.isEmpty())
                .toList();
    }
}
