package rasterlab.exercises.line;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.score.Cause;

/**
 * Finds the few simple mistakes that turn the exact line into what was drawn: at most one of the
 * place, one of the order, one of the ends and one of the ties, and no more than {@value #MOST}
 * together.
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
        WantedPixels forward = new WantedPixels(segment);
        WantedPixels backward = new WantedPixels(segment.reversed());
        for (LinePlace place : LinePlace.of(segment, actual)) {
            PixelRecording back = place.undo(actual);
            inDirection(forward, back, new Ends("first-pixel", "last-pixel"))
                    .ifPresent(causes -> found.add(with(place.cause(), causes)));
            inDirection(backward, back, new Ends("last-pixel", "first-pixel"))
                    .map(causes -> with(Optional.of(Cause.of("reversed")), causes))
                    .ifPresent(causes -> found.add(with(place.cause(), causes)));
        }
        int fewest = found.stream().mapToInt(List::size).min().orElse(MOST + 1);
        return fewest > MOST
                ? outOfTurn(actual)
                : found.stream().filter(one -> one.size() == fewest).distinct().toList();
    }

    /** Names the mistake where a pixel lacks at the end that is drawn first, or at the other. */
    private record Ends(String first, String last) {}

    /** Empty where it cannot be explained; no cause where it is right. */
    private Optional<List<Cause>> inDirection(
            WantedPixels pixels, PixelRecording actual, Ends ends) {
        int reach = cut ? limit + 1 : limit;
        PixelRecording exact = pixels.exact(reach);
        Optional<List<Cause>> right = atEnds(exact, actual, ends);
        PixelRecording near = pixels.nearest(actual, reach);
        Optional<List<Cause>> tied = atEnds(near, actual, ends);
        if (eitherOnTies) return tied;
        if (right.isPresent()) return right;
        return tied.map(causes -> with(Optional.of(Cause.of("ties")), causes));
    }

    private Optional<List<Cause>> atEnds(PixelRecording wanted, PixelRecording actual, Ends ends) {
        int all = cut ? limit : wanted.size();
        if (actual.size() == all && same(wanted, 0, actual)) return Optional.of(List.of());
        boolean isLong = wanted.size() > 2;
        if (cut)
            return actual.size() == all && same(wanted, 1, actual)
                    ? Optional.of(List.of(Cause.of(ends.first())))
                    : Optional.empty();
        if (actual.size() == all + 1 && isLong && begins(wanted, actual))
            return Optional.of(List.of(Cause.of("beyond-" + ends.last())));
        if (!isLong) return Optional.empty();
        if (actual.size() == all - 1 && same(wanted, 0, actual))
            return Optional.of(List.of(Cause.of(ends.last())));
        if (actual.size() == all - 1 && same(wanted, 1, actual))
            return Optional.of(List.of(Cause.of(ends.first())));
        boolean inner = all > 3 && actual.size() == all - 2 && same(wanted, 1, actual);
        return inner
                ? Optional.of(List.of(Cause.of(ends.first()), Cause.of(ends.last())))
                : Optional.empty();
    }

    /** Whether all that was drawn is wanted, beginning with that pixel. */
    private static boolean same(PixelRecording wanted, int from, PixelRecording actual) {
        if (from + actual.size() > wanted.size()) return false;
        for (int i = 0; i < actual.size(); i++)
            if (wanted.x(from + i) != actual.x(i) || wanted.y(from + i) != actual.y(i))
                return false;
        return true;
    }

    private static boolean begins(PixelRecording wanted, PixelRecording actual) {
        for (int i = 0; i < wanted.size(); i++)
            if (wanted.x(i) != actual.x(i) || wanted.y(i) != actual.y(i)) return false;
        return true;
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

    private static List<Cause> with(Optional<Cause> one, List<Cause> others) {
        return Stream.concat(one.stream(), others.stream()).toList();
    }
}
