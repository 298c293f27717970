package rasterlab.exercises.runner.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Runs the filter as the kernel does, for both machines, and once in the kernel itself. */
class SystemCallFilterTest {
    private static final int X86_64 = 0xC000003E;
    private static final int AARCH64 = 0xC00000B7;
    private static final long ALLOWED = 0x7fff0000L;
    private static final long NOT_PERMITTED = 0x00050001L;
    private static final long NOT_THERE = 0x00050026L;
    private static final long KILLED = 0x80000000L;

    /** The flags with which the C library makes a thread, and those of fork. */
    private static final int THREAD = 0x3d0f00;

    private static final int FORK = 0x1200011;

    @ParameterizedTest(name = "a child may call {0}")
    @CsvSource({
        "socket, 41, 198",
        "connect, 42, 203",
        "bind, 49, 200",
        "fork, 57, -1",
        "vfork, 58, -1",
        "ptrace, 101, 117",
        "kill, 62, 129",
        "process_vm_readv, 310, 270",
        "process_vm_writev, 311, 271",
        "unshare, 272, 97",
        "setns, 308, 268",
        "mount, 165, 40",
        "umount2, 166, 39",
        "pivot_root, 155, 41",
        "chroot, 161, 51",
        "bpf, 321, 280",
        "perf_event_open, 298, 241",
        "userfaultfd, 323, 282",
        "memfd_create, 319, 279",
        "keyctl, 250, 219",
        "add_key, 248, 217",
        "request_key, 249, 218",
        "seccomp, 317, 277",
        "init_module, 175, 105",
        "kexec_load, 246, 104",
        "reboot, 169, 142",
        "setuid, 105, 146",
        "unlink, 87, -1",
        "unlinkat, 263, 35",
        "mkdirat, 258, 34",
        "mknodat, 259, 33",
        "symlinkat, 266, 36",
        "shmget, 29, 194",
        "msgget, 68, 186",
        "semget, 64, 190",
        "sched_setscheduler, 144, 119",
        "settimeofday, 170, 170",
        "execveat, 322, 281",
        "personality, 135, 92",
        "io_setup, 206, 0"
    })
    void refuses(String name, int onX86, int onArm) {
        assertEquals(NOT_PERMITTED, answer(X86_64, onX86, 0));
        if (onArm >= 0) assertEquals(NOT_PERMITTED, answer(AARCH64, onArm, 0));
    }

    @ParameterizedTest(name = "Java cannot live without {0}")
    @CsvSource({
        "read, 0, 63",
        "write, 1, 64",
        "futex, 202, 98",
        "mmap, 9, 222",
        "openat, 257, 56",
        "execve, 59, 221",
        "exit_group, 231, 94",
        "clock_gettime, 228, 113",
        "wait4, 61, 260"
    })
    void allows(String name, int onX86, int onArm) {
        assertEquals(ALLOWED, answer(X86_64, onX86, 0));
        assertEquals(ALLOWED, answer(AARCH64, onArm, 0));
    }

    @Test
    @DisplayName("a child makes processes, or no threads")
    void cloneMakesThreadsOnly() {
        assertEquals(ALLOWED, answer(X86_64, 56, THREAD));
        assertEquals(ALLOWED, answer(AARCH64, 220, THREAD));
        assertEquals(NOT_PERMITTED, answer(X86_64, 56, FORK));
        assertEquals(NOT_PERMITTED, answer(AARCH64, 220, FORK));
    }

    @ParameterizedTest(name = "the C library does not try what is older than {0}")
    @CsvSource({"clone3, 435", "io_uring_setup, 425", "x32's read, 1073741824"})
    void whatIsNewIsNotThere(String name, int number) {
        assertEquals(NOT_THERE, answer(X86_64, number, THREAD));
    }

    @Test
    @DisplayName("numbers of another architecture pass, where socket is read")
    void anotherArchitectureEndsTheProcess() {
        assertEquals(KILLED, run(SystemCallFilter.Architecture.X86_64, 0x40000003, 0, 0));
        assertEquals(KILLED, run(SystemCallFilter.Architecture.AARCH64, X86_64, 63, 0));
    }

    @ParameterizedTest(name = "the kernel does not take the program for {0}")
    @EnumSource(SystemCallFilter.Architecture.class)
    void endsWithAnAnswer(SystemCallFilter.Architecture machine) {
        byte[] program = SystemCallFilter.program(machine);
        assertTrue(program.length / 8 < 4096, "too long");
        assertEquals(0x06, program[program.length - 8], "the last instruction returns");
    }

    @Test
    @Tag("slow")
    @EnabledOnOs(OS.LINUX)
    @DisplayName("the kernel lets a filtered process make a namespace or a process")
    void theKernelHoldsToIt(@TempDir Path folder) throws Exception {
        assumeTrue(Programs.onPath("bwrap").isPresent(), "bubblewrap is missing");
        assumeTrue(SystemCallFilter.program().isPresent(), "there is no table for this machine");
        Path filter = folder.resolve("filter");
        Files.write(filter, SystemCallFilter.program().orElseThrow());
        assertEquals("ok\n", output(filter, "echo ok"));
        for (String forbidden : List.of("exec unshare -U true", "/bin/true; echo made"))
            assertTrue(
                    output(filter, forbidden).matches("(?s).*(not permitted|annot fork).*"),
                    forbidden);
        assertNotEquals("lives\n", output(filter, "kill -0 1 && echo lives"));
    }

    private static String output(Path filter, String script)
            throws IOException, InterruptedException {
        var command = new ArrayList<>(List.of("sh", "-c", "exec \"$@\" 9<\"$0\""));
        command.addAll(List.of(filter.toString(), "bwrap", "--ro-bind", "/", "/"));
        command.addAll(List.of("--seccomp", "9", "--", "sh", "-c", script));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        try (var in = process.getInputStream()) {
            String said = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            assertTrue(process.waitFor(1, TimeUnit.MINUTES), "does not end");
            return said;
        } finally {
            process.destroyForcibly();
        }
    }

    private static long answer(int architecture, int number, int argument) {
        var machine =
                architecture == X86_64
                        ? SystemCallFilter.Architecture.X86_64
                        : SystemCallFilter.Architecture.AARCH64;
        return run(machine, architecture, number, argument);
    }

    /** Runs the filter on one call, by the rules of the kernel's interpreter. */
    private static long run(
            SystemCallFilter.Architecture machine, int architecture, int number, int argument) {
        ByteBuffer program = little(SystemCallFilter.program(machine));
        ByteBuffer call = little(new byte[64]);
        call.putInt(0, number).putInt(4, architecture).putInt(16, argument);
        int loaded = 0;
        for (int at = 0; ; at += 8) {
            int code = program.getShort(at) & 0xffff;
            int yes = program.get(at + 2) & 0xff;
            int no = program.get(at + 3) & 0xff;
            int value = program.getInt(at + 4);
            switch (code) {
                case 0x20 -> loaded = call.getInt(value);
                case 0x06 -> {
                    return value & 0xffffffffL;
                }
                case 0x15 -> at += 8 * (loaded == value ? yes : no);
                case 0x35 -> at += 8 * (Integer.compareUnsigned(loaded, value) >= 0 ? yes : no);
                case 0x45 -> at += 8 * ((loaded & value) != 0 ? yes : no);
                default -> throw new AssertionError("instruction " + code);
            }
        }
    }

    private static ByteBuffer little(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }
}
