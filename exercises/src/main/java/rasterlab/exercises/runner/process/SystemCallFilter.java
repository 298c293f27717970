package rasterlab.exercises.runner.process;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Lists what a child may ask of the kernel, as a program that the kernel runs at each system call:
 * those of system-calls.txt, and threads. Anything else is refused as not permitted, and what is
 * newer than the table as not there, for which the C library has other ways.
 *
 * <p>Source: Linux, Documentation/userspace-api/seccomp_filter.rst; the program is classic BPF,
 * which S. McCanne and V. Jacobson describe in "The BSD Packet Filter", USENIX Winter 1993.
 */
public final class SystemCallFilter {
    private static final int LOAD_WORD = 0x20;
    private static final int JUMP_IF_EQUAL = 0x15;
    private static final int JUMP_IF_AT_LEAST = 0x35;
    private static final int JUMP_IF_SET = 0x45;
    private static final int RETURN = 0x06;

    /** Where the kernel puts number, architecture and the first argument, in bytes. */
    private static final int NUMBER = 0;

    private static final int ARCHITECTURE = 4;
    private static final int FIRST_ARGUMENT = 16;

    private static final int ALLOW = 0x7fff0000;
    private static final int KILL_PROCESS = 0x80000000;
    private static final int NOT_PERMITTED = 0x00050000 | 1;
    private static final int NOT_THERE = 0x00050000 | 38;
    private static final int CLONE_THREAD = 0x10000;

    /**
     * The first number that is the same everywhere; what it names came with Linux 5.1 and later.
     */
    private static final int FIRST_NEW = 424;

    private static final int INSTRUCTION_BYTES = 8;

    /** An architecture for which the table has numbers. */
    enum Architecture {
        X86_64(0xC000003E, 1, 56),
        AARCH64(0xC00000B7, 2, 220);

        private final int code;
        private final int column;
        private final int clone;

        Architecture(int code, int column, int clone) {
            this.code = code;
            this.column = column;
            this.clone = clone;
        }
    }

    private SystemCallFilter() {}

    /** The program for this machine; empty where there is none. */
    public static Optional<byte[]> program() {
        if (!System.getProperty("os.name").equals("Linux")) return Optional.empty();
        return switch (System.getProperty("os.arch")) {
            case "amd64" -> Optional.of(program(Architecture.X86_64));
            case "aarch64" -> Optional.of(program(Architecture.AARCH64));
            default -> Optional.empty();
        };
    }

    static byte[] program(Architecture machine) {
        List<Integer> allowed = allowed(machine);
        ByteBuffer program =
                ByteBuffer.allocate((2 * allowed.size() + 11) * INSTRUCTION_BYTES)
                        .order(ByteOrder.LITTLE_ENDIAN);
        put(program, LOAD_WORD, 0, 0, ARCHITECTURE);
        put(program, JUMP_IF_EQUAL, 1, 0, machine.code);
        put(program, RETURN, 0, 0, KILL_PROCESS);
        put(program, LOAD_WORD, 0, 0, NUMBER);
        for (int number : allowed) {
            put(program, JUMP_IF_EQUAL, 0, 1, number);
            put(program, RETURN, 0, 0, ALLOW);
        }
        put(program, JUMP_IF_AT_LEAST, 0, 1, FIRST_NEW);
        put(program, RETURN, 0, 0, NOT_THERE);
        put(program, JUMP_IF_EQUAL, 0, 3, machine.clone);
        put(program, LOAD_WORD, 0, 0, FIRST_ARGUMENT);
        put(program, JUMP_IF_SET, 0, 1, CLONE_THREAD);
        put(program, RETURN, 0, 0, ALLOW);
        put(program, RETURN, 0, 0, NOT_PERMITTED);
        return program.array();
    }

    /**
     * @param yes instructions that are passed over where the condition holds
     * @param no those that are where it does not
     */
    private static void put(ByteBuffer program, int code, int yes, int no, int value) {
        program.putShort((short) code).put((byte) yes).put((byte) no).putInt(value);
    }

    private static List<Integer> allowed(Architecture machine) {
        List<Integer> numbers = new ArrayList<>();
        try (var in = SystemCallFilter.class.getResourceAsStream("system-calls.txt");
                var lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                if (line.isBlank() || line.startsWith("#")) continue;
                String number = line.split(" ")[machine.column];
                if (!number.equals("-")) numbers.add(Integer.parseInt(number));
            }
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read the table of system calls", e);
        }
        return numbers;
    }

    /**
     * Whether the kernel filters the system calls of every process below that one, as it tells
     * itself.
     */
    public static boolean holdsBelow(ProcessHandle child) {
        List<ProcessHandle> below = child.descendants().toList();
        return !below.isEmpty() && below.stream().allMatch(SystemCallFilter::isFiltered);
    }

    private static boolean isFiltered(ProcessHandle process) {
        try {
            Path status = Path.of("/proc", Long.toString(process.pid()), "status");
            return Files.readAllLines(status).contains("Seccomp:\t2");
        } catch (IOException unread) {
            return false;
        }
    }
}
