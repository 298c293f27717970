package rasterlab.exercises.pixels;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.score.Cause;

/**
 * Finds the few simple mistakes that turn the exact pixels into what was drawn: of the place, of
 * the order, of the ends and of the ties, and no more than {@value #MOST} together.
 */
final class PixelMistakes {
    /** The codes of what can be found. */
    static final Set<String> CODES =
            Set.of(
                    "first-pixel",
                    "last-pixel",
                    "beyond-first-pixel",
                    "beyond-last-pixel",
                    "reversed",
                    "out-of-order",
                    "again",
                    "ties",
                    "shifted",
                    "mirrored-left-right",
                    "mirrored-up-down",
                    "swapped-axes");

    private static final int MOST = 2;

    private final PixelPath path;
    private final int limit;
    private final boolean cut;
    private final boolean eitherOnTies;

    /**
     * @param limit the most pixels that are looked at
     * @param cut whether the path has more than that
     * @param eitherOnTies whether either pixel of a tie is right
     */
    PixelMistakes(PixelPath path, int limit, boolean cut, boolean eitherOnTies) {
        this.path = path;
        this.limit = limit;
        this.cut = cut;
        this.eitherOnTies = eitherOnTies;
    }

    /** The explanations with the fewest mistakes; none where nothing simple explains it. */
    List<List<Cause>> of(PixelRecording actual) {
        if (actual.size() == 0) return List.of(List.of(Cause.of("nothing")));
        List<List<Cause>> found = new ArrayList<>();
        Map<PixelPath, PixelPath> backward = new IdentityHashMap<>();
        for (PixelPlace place : PixelPlace.of(path, actual)) {
            PixelRecording back = place.undo(actual);
            PixelPath forward = place.path();
            for (List<Cause> causes : inDirection(forward, back, "first-pixel", "last-pixel"))
                found.add(with(place.causes(), causes));
            List<Cause> reversed = with(place.causes(), List.of(Cause.of("reversed")));
            for (List<Cause> causes :
                    inDirection(
                            backward.computeIfAbsent(forward, PixelPath::reversed),
                            back,
                            "last-pixel",
                            "first-pixel")) found.add(with(reversed, causes));
        }
        int fewest = found.stream().mapToInt(List::size).min().orElse(MOST + 1);
        return fewest > MOST
                ? outOfTurn(actual)
                : found.stream().filter(one -> one.size() == fewest).distinct().toList();
    }

    /**
     * The causes in one direction; empty where it cannot be explained, one without a cause where it
     * is right.
     */
    private List<List<Cause>> inDirection(
            PixelPath pixels, PixelRecording actual, String first, String last) {
        int reach = cut ? limit + 1 : limit;
        PixelRecording near = pixels.nearest(actual, reach);
        List<List<Cause>> tied = inTurn(near, actual, first, last);
        if (eitherOnTies) return tied;
        List<List<Cause>> right = inTurn(pixels.exact(reach), actual, first, last);
        return right.isEmpty()
                ? tied.stream().map(causes -> with(List.of(Cause.of("ties")), causes)).toList()
                : right;
    }

    private List<List<Cause>> inTurn(
            PixelRecording wanted, PixelRecording actual, String first, String last) {
        boolean cutThere = cut && actual.size() == limit;
        if (cut && !cutThere) return List.of();
        List<List<Cause>> atEnds = new PixelEnds(wanted, actual, cut, first, last).explanations();
        if (!atEnds.isEmpty()) return atEnds;
        Optional<Cause> again = new Repetition(actual).explains(wanted, cut, first, last);
        return again.map(cause -> List.of(List.of(cause))).orElse(List.of());
    }

    /** The right pixels, but more than once or in another order. */
    private List<List<Cause>> outOfTurn(PixelRecording actual) {
        PixelRecording wanted = eitherOnTies ? path.nearest(actual, limit) : path.exact(limit);
        PixelSet all = PixelSet.of(wanted);
        PixelSet drawn = PixelSet.of(actual);
        boolean alike =
                drawn.size() == all.size() && drawn.filter((x, y) -> !all.contains(x, y)).isEmpty();
        if (!alike) return List.of();
        boolean eachOnce = actual.size() == wanted.size();
        return List.of(List.of(Cause.of(eachOnce ? "out-of-order" : "again")));
    }

    private static List<Cause> with(List<Cause> some, List<Cause> others) {
        List<Cause> all = new ArrayList<>(some);
        all.addAll(others);
        return List.copyOf(all);
    }
}
