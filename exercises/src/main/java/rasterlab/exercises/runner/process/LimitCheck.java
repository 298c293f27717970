package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Looks whether the limits that a child was started with hold, as the kernel tells them. */
public final class LimitCheck {
    private static final int NAME_WIDTH = 26;

    private LimitCheck() {}

    /**
     * The first limit that does not hold for a process or for one below it; empty where all do.
     *
     * @param processes whether their number is limited too
     */
    public static Optional<String> fault(ProcessHandle child, boolean processes) {
        List<ProcessHandle> all = new java.util.ArrayList<>(child.descendants().toList());
        all.add(child);
        for (ProcessHandle one : all) {
            Path file = Path.of("/proc", Long.toString(one.pid()), "limits");
            try {
                Optional<String> fault = fault(Files.readAllLines(file), processes);
                if (fault.isPresent()) return fault;
            } catch (IOException unread) {
                return Optional.of(file + " cannot be read");
            }
        }
        return Optional.empty();
    }

    /**
     * @param limits lines of a process's limits: name, what holds now, the most that can be set
     */
    static Optional<String> fault(List<String> limits, boolean processes) {
        for (Map.Entry<String, Integer> wanted : wanted(processes).entrySet()) {
            String name = wanted.getKey();
            Optional<String> line = limits.stream().filter(l -> l.startsWith(name)).findFirst();
            String[] values =
                    line.map(l -> l.substring(Math.min(l.length(), NAME_WIDTH)).strip())
                            .orElse("")
                            .split("\\s+");
            String expected = wanted.getValue().toString();
            boolean holds =
                    values.length >= 2 && values[0].equals(expected) && values[1].equals(expected);
            if (!holds) return Optional.of(line.map(l -> l.replaceAll("\\s+", " ")).orElse(name));
        }
        return Optional.empty();
    }

    private static Map<String, Integer> wanted(boolean processes) {
        Map<String, Integer> wanted = new LinkedHashMap<>();
        wanted.put("Max core file size", 0);
        wanted.put("Max file size", 0);
        wanted.put("Max open files", Programs.MOST_FILES);
        wanted.put("Max cpu time", Programs.MOST_SECONDS);
        if (processes) wanted.put("Max processes", Programs.MOST_PROCESSES);
        return wanted;
    }
}
