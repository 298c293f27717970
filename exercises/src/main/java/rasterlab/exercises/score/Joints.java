package rasterlab.exercises.score;

import java.util.List;
import java.util.Optional;

/**
 * The texts that stand between the sentences of a message. Most messages are a list; one on what
 * all failures share is prose: the mistake, where it shows, and an example.
 *
 * @param keys of the sentences, in order
 */
record Joints(List<String> keys) {
    /** The key of what stands before that sentence; nothing before the first. */
    Optional<String> before(int place) {
        if (place == 0) return Optional.empty();
        if (!isProse()) return Optional.of("join.list");
        return Optional.of(within(keys.get(place - 1), keys.get(place)));
    }

    /** The key of what stands behind the last sentence, if anything does. */
    Optional<String> end() {
        return isProse() ? Optional.of("join.end") : Optional.empty();
    }

    private boolean isProse() {
        return !keys.isEmpty() && keys.get(0).startsWith("cause.");
    }

    private static String within(String before, String next) {
        boolean afterPlace = before.startsWith("where.");
        if (next.startsWith("where.")) return afterPlace ? "join.where.more" : "join.where";
        if (next.endsWith(".example")) return "join.example";
        if (before.startsWith("cause.")) return "join.mistake";
        return afterPlace ? "join.other" : "join.both";
    }
}
