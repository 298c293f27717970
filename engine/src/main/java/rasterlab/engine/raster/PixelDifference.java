package rasterlab.engine.raster;

import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Two pictures of single pixels, one exact and one drawn, told apart.
 *
 * @param right drawn, and nothing to object to
 * @param missing in the exact picture but not drawn
 * @param extra drawn but not in the exact picture
 */
public record PixelDifference(PixelSet right, PixelSet missing, PixelSet extra) {
    private static final int MOST_COLUMNS = 80;
    private static final int MOST_ROWS = 40;

    public static PixelDifference of(PixelRecording exact, PixelRecording actual) {
        return of(exact, actual, (x, y) -> false);
    }

    /**
     * The difference under a tolerance.
     *
     * @param forgiven pixels that may be drawn or not: drawn they count as right, not drawn they
     *     count for nothing
     */
    public static PixelDifference of(
            PixelRecording exact, PixelRecording actual, PixelPredicate forgiven) {
        PixelSet wanted = PixelSet.of(exact);
        PixelSet drawn = PixelSet.of(actual);
        return new PixelDifference(
                drawn.filter((x, y) -> wanted.contains(x, y) || forgiven.test(x, y)),
                wanted.filter((x, y) -> !drawn.contains(x, y) && !forgiven.test(x, y)),
                drawn.filter((x, y) -> !wanted.contains(x, y) && !forgiven.test(x, y)));
    }

    /**
     * The largest distance, max(|Δx|, |Δy|), from a missing pixel to a drawn one or from an extra
     * pixel to an exact one; where nothing is drawn, the number of missing pixels.
     *
     * @param exact what {@code missing} was missed from
     * @param actual what {@code extra} was found in
     */
    public double worst(PixelRecording exact, PixelRecording actual) {
        return Math.max(farthest(missing, actual), farthest(extra, exact));
    }

    private static double farthest(PixelSet from, PixelRecording to) {
        if (from.isEmpty()) return 0;
        if (to.size() == 0) return from.size();
        var nearest = new NearestPixel(to);
        long farthest = 0;
        for (int i = 0; i < from.size(); i++)
            farthest = Math.max(farthest, nearest.distance(from.x(i), from.y(i)));
        return farthest;
    }

    /** Whether there are neither missing nor extra pixels. */
    public boolean isEmpty() {
        return missing.isEmpty() && extra.isEmpty();
    }

    /** The smallest box around all three sets; none if there is no pixel at all. */
    public Optional<PixelWindow> box() {
        if (right.isEmpty() && isEmpty()) return Optional.empty();
        return Optional.of(
                new PixelWindow(
                        xs().min().orElseThrow(),
                        ys().min().orElseThrow(),
                        xs().max().orElseThrow(),
                        ys().max().orElseThrow()));
    }

    /**
     * A part of the box around a pixel of it, of at most 80 columns and 40 rows: all of a smaller
     * box.
     */
    public PixelWindow around(int x, int y) {
        return box().orElseThrow().around(x, y, MOST_COLUMNS, MOST_ROWS);
    }

    /**
     * A part of the box as rows of characters, top row first, joined by line feeds: {@code #}
     * right, {@code +} extra, {@code -} missing, {@code .} none of them. Where it is not the whole
     * box, a first line says which part it is.
     */
    public String text(PixelWindow shown) {
        PixelWindow whole = box().orElseThrow();
        var text = new StringBuilder();
        if (!shown.equals(whole)) text.append(part(shown, whole)).append('\n');
        for (long y = shown.ymin(); y <= shown.ymax(); y++) {
            if (y > shown.ymin()) text.append('\n');
            for (long x = shown.xmin(); x <= shown.xmax(); x++) text.append(mark((int) x, (int) y));
        }
        return text.toString();
    }

    private static String part(PixelWindow shown, PixelWindow whole) {
        return "columns "
                + range(shown.xmin(), shown.xmax(), whole.xmin(), whole.xmax())
                + ", rows "
                + range(shown.ymin(), shown.ymax(), whole.ymin(), whole.ymax());
    }

    private static String range(int from, int to, int wholeFrom, int wholeTo) {
        return from + ".." + to + " of " + wholeFrom + ".." + wholeTo;
    }

    private char mark(int x, int y) {
        if (right.contains(x, y)) return '#';
        if (extra.contains(x, y)) return '+';
        return missing.contains(x, y) ? '-' : '.';
    }

    private IntStream xs() {
        return Stream.of(right, missing, extra)
                .flatMapToInt(set -> IntStream.range(0, set.size()).map(set::x));
    }

    private IntStream ys() {
        return Stream.of(right, missing, extra)
                .flatMapToInt(set -> IntStream.range(0, set.size()).map(set::y));
    }
}
