package rasterlab.engine.study.measuring;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * A machine that studies are measured on.
 *
 * @param processor its model name, or the architecture where the system does not tell
 * @param cores available to this process
 * @param heapBytes the most heap this process may use
 */
public record Machine(String system, String processor, int cores, long heapBytes, String java) {
    public Machine {
        if (cores < 1) throw new IllegalArgumentException("cores must be at least 1, got " + cores);
        if (heapBytes < 1)
            throw new IllegalArgumentException("heap must have at least 1 byte, got " + heapBytes);
    }

    /** The machine that this runs on. */
    public static Machine here() {
        Runtime runtime = Runtime.getRuntime();
        return new Machine(
                System.getProperty("os.name") + " " + System.getProperty("os.version"),
                processorName(),
                runtime.availableProcessors(),
                runtime.maxMemory(),
                System.getProperty("java.version")
                        + ", "
                        + System.getProperty("java.vm.name")
                        + ", "
                        + System.getProperty("java.vendor"));
    }

    /** Processor, system and Java in one line. */
    public String described() {
        return processor + ", " + system + ", Java " + java;
    }

    private static String processorName() {
        String architecture = System.getProperty("os.arch");
        Path linux = Path.of("/proc/cpuinfo");
        if (!Files.isReadable(linux)) return architecture;
        try (Stream<String> lines = Files.lines(linux)) {
            return lines.filter(line -> line.startsWith("model name"))
                    .map(line -> line.substring(line.indexOf(':') + 1).strip())
                    .findFirst()
                    .orElse(architecture);
        } catch (IOException e) {
            return architecture;
        }
    }
}
