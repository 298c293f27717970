package rasterlab.exercises.line;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.score.Cause;

/**
 * Finds the few simple mistakes that turn the exact line into what was drawn: of the place, of the
 * order, of the ends and of the ties, and no more than {@value #MOST} together.
 */
final class LineMistakes {
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

    private final Segment segment;
    private final int limit;
    private final boolean cut;
    private final boolean eitherOnTies;

    /**
     * @param limit the most pixels that are looked at
     * @param cut whether the line has more than that
     * @param eitherOnTies whether either pixel of a tie is right
     */
    LineMistakes(Segment segment, int limit, boolean cut, boolean eitherOnTies) {
        this.segment = segment;
        this.limit = limit;
        this.cut = cut;
        this.eitherOnTies = eitherOnTies;
    }

    /** The explanations with the fewest mistakes; none where nothing simple explains it. */
    List<List<Cause>> of(PixelRecording actual) {
        if (actual.size() == 0) return List.of(List.of(Cause.of("nothing")));
        List<List<Cause>> found = new ArrayList<>();
        Map<Segment, WantedPixels> lines = new HashMap<>();
        for (LinePlace place : LinePlace.of(segment, actual)) {
            PixelRecording back = place.undo(actual);
            WantedPixels forward = lines.computeIfAbsent(place.line(), WantedPixels::new);
            for (List<Cause> causes : inDirection(forward, back, "first-pixel", "last-pixel"))
                found.add(with(place.causes(), causes));
            WantedPixels backward =
                    lines.computeIfAbsent(place.line().reversed(), WantedPixels::new);
            List<Cause> reversed = with(place.causes(), List.of(Cause.of("reversed")));
            for (List<Cause> causes : inDirection(backward, back, "last-pixel", "first-pixel"))
                found.add(with(reversed, causes));
        }
        int fewest = found.stream().mapToInt(List::size).min().orElse(MOST + 1);
        return fewest > MOST
                ? outOfTurn(actual)
                : found.stream().filter(one -> one.size() == fewest).distinct().toList();
    }

    /** Empty where it cannot be explained; one without a cause where it is right. */
    private List<List<Cause>> inDirection(
            WantedPixels pixels, PixelRecording actual, String first, String last) {
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
        List<List<Cause>> atEnds = new LineEnds(wanted, actual, cut, first, last).explanations();
        if (!atEnds.isEmpty()) return atEnds;
        Optional<Cause> again = new Repetition(actual).explains(wanted, cut, first, last);
        return again.map(cause -> List.of(List.of(cause))).orElse(List.of());
    }

    /** The right pixels, but more than once or in another order. */
    private List<List<Cause>> outOfTurn(PixelRecording actual) {
        WantedPixels pixels = new WantedPixels(segment);
        PixelRecording wanted = eitherOnTies ? pixels.nearest(actual, limit) : pixels.exact(limit);
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
