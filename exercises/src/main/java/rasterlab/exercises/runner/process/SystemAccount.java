package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.math.BigInteger;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The account that this process runs for, by the kernel's numbers: a name may mean anything. */
public final class SystemAccount {
    private static final Path STATUS = Path.of("/proc/self/status");

    /** CAP_SYS_ADMIN and CAP_SYS_RESOURCE: their holders may start any number of processes. */
    private static final List<Integer> UNLIMITED = List.of(21, 24);

    private SystemAccount() {}

    /** Whether the kernel lets it start any number of processes whatever limit is set. */
    public static boolean exceedsLimits() {
        try {
            return exceedsLimits(Files.readAllLines(STATUS));
        } catch (IOException noProc) {
            return "root".equals(System.getProperty("user.name"));
        }
    }

    /**
     * @param status lines of a process's status, as the kernel writes them
     */
    static boolean exceedsLimits(List<String> status) {
        boolean root = values(status, "Uid:").anyMatch("0"::equals);
        return root
                || values(status, "CapEff:")
                        .map(mask -> new BigInteger(mask, 16))
                        .anyMatch(mask -> UNLIMITED.stream().anyMatch(mask::testBit));
    }

    private static Stream<String> values(List<String> status, String name) {
        return status.stream()
                .filter(line -> line.startsWith(name))
                .flatMap(line -> Stream.of(line.substring(name.length()).strip().split("\\s+")));
    }
}
