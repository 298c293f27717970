package rasterlab.tests.watchdog;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;

/** Events that kept the event thread for long, as one text; those alike on one line. */
final class LongStays {
    private static final int LINES = 12;

    private LongStays() {}

    /** The text on long stays; empty where there is none. */
    static String text(String test, List<LongStay> stays) {
        if (stays.isEmpty()) return "";
        List<List<LongStay>> alike =
                stays.stream()
                        .collect(Collectors.groupingBy(each -> each.name() + each.place()))
                        .values()
                        .stream()
                        .sorted(Comparator.comparingLong(LongStays::longest).reversed())
                        .toList();
        String rest = alike.size() > LINES ? "\n  and " + (alike.size() - LINES) + " more" : "";
        return "%s: the event thread was kept for more than 50 ms, %d ×%n"
                        .formatted(test, stays.size())
                + alike.stream().limit(LINES).map(LongStays::line).collect(Collectors.joining("\n"))
                + rest;
    }

    private static long longest(List<LongStay> stays) {
        return stays.stream().mapToLong(LongStay::nanos).max().orElseThrow();
    }

    private static String line(List<LongStay> alike) {
        return "  %d ms%s: %s, mostly at %s"
                .formatted(
                        longest(alike) / 1_000_000,
                        alike.size() == 1 ? "" : " at most, " + alike.size() + " times",
                        alike.get(0).name(),
                        alike.get(0).place());
    }
}
