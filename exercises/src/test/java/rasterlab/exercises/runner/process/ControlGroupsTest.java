package rasterlab.exercises.runner.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.exercises.runner.process.ControlGroups.FoundGroups;
import rasterlab.exercises.runner.process.ControlGroups.GroupLimits;
import rasterlab.exercises.score.Message;

/**
 * Control groups are made with their limits, or it is said why not. The hierarchy is a folder of
 * plain files; tests of the kernel's own are skipped where it gives no part of it, as it does to
 * {@code systemd-run --pipe -p Delegate="memory pids cpu" ./mvnw …}.
 */
@EnabledOnOs(OS.LINUX)
class ControlGroupsTest {
    private static final long PROCESS = 4711;
    private static final int KILLED = 128 + 9;

    /** Takes a core for a second, then is ended. */
    private static final String BUSY = "timeout 1 sh -c 'while :; do :; done'";

    /** Tells what the kernel noted of the processor time of the shell's group. */
    private static final String PROCESSOR_TIME =
            "cat /sys/fs/cgroup$(sed -n s/^0:://p /proc/self/cgroup)/cpu.stat";

    @TempDir private Path hierarchy;
    private Path own;

    @BeforeEach
    void ownGroup() throws IOException {
        own = Files.createDirectory(hierarchy.resolve("service"));
        Files.writeString(own.resolve("cgroup.controllers"), "cpuset cpu io memory pids\n");
        Files.writeString(own.resolve("cgroup.procs"), PROCESS + "\n");
    }

    @Test
    @DisplayName("a child's group lacks a limit, or the server stays where no group may be limited")
    void makesGroupsWithLimits() throws IOException {
        ControlGroups groups = ControlGroups.find(own, PROCESS).groups().orElseThrow();
        assertEquals("" + PROCESS, text(own.resolve(ControlGroups.OWN).resolve("cgroup.procs")));
        assertEquals("+memory +pids +cpu", text(own.resolve("cgroup.subtree_control")));
        groups.make(new GroupLimits(384L << 20, 128, 2));
        Path made = only("rasterlab-child-" + ProcessHandle.current().pid());
        assertEquals("402653184", text(made.resolve("memory.max")));
        assertEquals("128", text(made.resolve("pids.max")));
        assertEquals("200000 100000", text(made.resolve("cpu.max")));
    }

    @Test
    @DisplayName("a child begins before it is in its group")
    void aChildJoinsBeforeItBegins() throws Exception {
        ControlGroups groups = ControlGroups.find(own, PROCESS).groups().orElseThrow();
        ControlGroup group = groups.make(new GroupLimits(384L << 20, 128, 1));
        Path made = only("rasterlab-child-" + ProcessHandle.current().pid());
        List<String> command =
                group.joined(List.of("/bin/cat", made.resolve("cgroup.procs").toString()));
        Process process = new ProcessBuilder(command).start();
        String seen = new String(process.getInputStream().readAllBytes()).strip();
        assertEquals("" + process.pid(), seen);
        assertTrue(group.has(process.pid()));
        assertFalse(group.has(1));
    }

    @Test
    @DisplayName("a second start in one process is taken for one in a group of others")
    void goesOnFromWhereItMoved() throws IOException {
        assertTrue(ControlGroups.find(own, PROCESS).groups().isPresent());
        Files.writeString(own.resolve("cgroup.procs"), "");
        Path moved = own.resolve(ControlGroups.OWN);
        assertEquals(Message.NONE, ControlGroups.find(moved, PROCESS).lacking());
        assertFalse(Files.exists(moved.resolve(ControlGroups.OWN)), "moved once more");
    }

    @Test
    @DisplayName("groups of a server that was killed stay for ever")
    void removesLeftovers() throws IOException {
        Path left = Files.createDirectory(own.resolve("rasterlab-child-1-1"));
        Path other = Files.createDirectory(own.resolve("backup"));
        ControlGroups.find(own, PROCESS);
        assertFalse(Files.exists(left));
        assertTrue(Files.exists(other));
    }

    @ParameterizedTest(name = "{0} is kept quiet")
    @CsvSource({
        "a missing controller, isolation.groups-kinds",
        "another program in the group, isolation.groups-shared",
        "a limit that does not hold, isolation.groups-fail",
        "a hierarchy of version 1, isolation.groups-fail"
    })
    void saysWhyThereAreNone(String what, String key) throws IOException {
        switch (what) {
            case "a missing controller" ->
                    Files.writeString(own.resolve("cgroup.controllers"), "cpu memory");
            case "another program in the group" ->
                    Files.writeString(own.resolve("cgroup.procs"), "1\n" + PROCESS);
            case "a limit that does not hold" ->
                    Files.createDirectory(own.resolve("cgroup.subtree_control"));
            default -> Files.delete(own.resolve("cgroup.controllers"));
        }
        FoundGroups found = ControlGroups.find(own, PROCESS);
        assertTrue(found.groups().isEmpty());
        assertEquals(key, found.lacking().sentences().get(0).key());
        if (key.endsWith("kinds"))
            assertEquals(Message.of("isolation.groups-kinds", "pids"), found.lacking());
    }

    @Test
    @DisplayName("the group of this process is looked for in the wrong place")
    void findsItsOwnGroup() {
        String version1 = "31 28 0:27 / /sys/fs/cgroup/pids rw - cgroup cgroup rw,pids";
        String version2 = "35 28 0:30 / /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw";
        List<String> groups = List.of("4:memory:/a", "0::/system.slice/rasterlab.service");
        assertEquals(
                Optional.of(Path.of("/sys/fs/cgroup/system.slice/rasterlab.service")),
                ControlGroups.own(List.of(version1, version2), groups));
        assertEquals(Optional.empty(), ControlGroups.own(List.of(version1), groups));
        assertEquals(Optional.empty(), ControlGroups.own(List.of(version2), groups.subList(0, 1)));
    }

    @Test
    @DisplayName("a group of the kernel's keeps its processes, or stays when they are killed")
    void aRealGroupEndsWithItsProcesses() throws Exception {
        Optional<Path> top =
                ControlGroups.own(
                        Files.readAllLines(Path.of("/proc/self/mountinfo")), List.of("0::/"));
        assumeTrue(top.isPresent() && Files.isWritable(top.get()), "no cgroup v2 can be written");
        Path made =
                Files.createDirectory(
                        top.get().resolve("rasterlab-test-" + ProcessHandle.current().pid()));
        ControlGroup group = new ControlGroup(made);
        Process process =
                new ProcessBuilder(group.joined(List.of("/bin/sh", "-c", "echo here; read line")))
                        .start();
        try {
            assertEquals("here", process.inputReader().readLine());
            assertTrue(group.has(process.pid()));
        } finally {
            group.end();
            process.destroyForcibly();
        }
        assertTrue(process.waitFor(1, TimeUnit.MINUTES));
        assertFalse(Files.exists(made), "the group stays");
    }

    @Test
    @DisplayName("a child takes more memory than the kernel may give to its group")
    void theKernelEndsWhatTakesTooMuchMemory() throws Exception {
        ControlGroup group = real(new GroupLimits(32L << 20, 8, 1));
        try {
            Process process = run(group, "/usr/bin/tail", "/dev/zero");
            assertEquals(KILLED, process.exitValue());
            assertTrue(group.isOutOfMemory(), "its end is not told from another");
        } finally {
            group.end();
        }
    }

    @Test
    @DisplayName("a child starts more processes than its group may have")
    void theKernelStartsNoMoreProcesses() throws Exception {
        ControlGroup group = real(new GroupLimits(256L << 20, 4, 1));
        try {
            Process process = run(group, "/bin/sh", "-c", "sleep 9 & sleep 9 & sleep 9 & sleep 9");
            assertTrue(process.exitValue() != 0, "all were started");
        } finally {
            group.end();
        }
    }

    @Test
    @DisplayName("a child runs on more cores than its group may")
    void theKernelHoldsBackWhatRunsOnTooManyCores() throws Exception {
        assumeTrue(Runtime.getRuntime().availableProcessors() > 1, "there is one core");
        ControlGroup group = real(new GroupLimits(256L << 20, 16, 1));
        try {
            String three = BUSY + " & " + BUSY + " & " + BUSY + " & wait; ";
            Process process = run(group, "/bin/sh", "-c", three + PROCESSOR_TIME);
            String told = new String(process.getInputStream().readAllBytes());
            assertTrue(told.lines().anyMatch(line -> line.matches("nr_throttled [1-9]\\d*")), told);
        } finally {
            group.end();
        }
    }

    /**
     * A group of the kernel's, below that of this process; the test is skipped where there is none.
     */
    private static ControlGroup real(GroupLimits limits) throws IOException {
        FoundGroups found = ControlGroups.find();
        assumeTrue(found.groups().isPresent(), () -> found.lacking().in("en"));
        return found.groups().orElseThrow().make(limits);
    }

    private static Process run(ControlGroup group, String... command) throws Exception {
        Process process = new ProcessBuilder(group.joined(List.of(command))).start();
        assertTrue(process.waitFor(1, TimeUnit.MINUTES), "it does not end");
        return process;
    }

    private Path only(String start) throws IOException {
        try (var all = Files.list(own)) {
            List<Path> found =
                    all.filter(one -> one.getFileName().toString().startsWith(start)).toList();
            assertEquals(1, found.size(), found::toString);
            return found.get(0);
        }
    }

    private static String text(Path file) throws IOException {
        return Files.readString(file).strip();
    }
}
