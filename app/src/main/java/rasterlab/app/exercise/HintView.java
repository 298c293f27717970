package rasterlab.app.exercise;

import java.util.List;
import java.util.OptionalInt;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Hint;

/**
 * The hints of an exercise as the user has them.
 *
 * @param steps that there are; 0 where there are no hints
 * @param shown texts of the steps that were shown, in Markdown
 * @param cost points of the next step; empty where all are shown or nobody has said yet
 * @param origin who counts
 */
public record HintView(int steps, List<LocalizedText> shown, OptionalInt cost, Origin origin) {
    /** Who counts what hints cost. */
    public enum Origin {
        /** Nobody counts the hints: there is no server. */
        PRACTICE,
        /** A server that was not asked yet which ones were shown. */
        UNASKED,
        /** A server. */
        SERVER
    }

    public HintView {
        shown = List.copyOf(shown);
    }

    /** The hints shown without a server, as many as given. */
    static HintView practice(Exercise exercise, int shown) {
        List<Hint> all = exercise.hints();
        return new HintView(
                all.size(),
                all.subList(0, shown).stream().map(one -> LocalizedText.of(one::text)).toList(),
                shown < all.size() ? OptionalInt.of(all.get(shown).cost()) : OptionalInt.empty(),
                Origin.PRACTICE);
    }

    /** The hints before a server was asked. */
    static HintView unasked(Exercise exercise) {
        return new HintView(
                exercise.hints().size(), List.of(), OptionalInt.empty(), Origin.UNASKED);
    }

    /** Whether something is left to ask for. */
    public boolean more() {
        return origin == Origin.UNASKED ? steps > 0 : shown.size() < steps;
    }
}
