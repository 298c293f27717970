package rasterlab.engine.raster;

import java.util.Optional;

/**
 * The pixel, first in the order of drawing, in which what is drawn is not what is exact.
 *
 * @param drawn what is drawn in its place, where that is one pixel
 */
public record FirstDifference(DifferenceKind kind, Pixel pixel, Optional<Pixel> drawn) {
    /** The fault there, if no pixel before it is wrong. */
    public enum DifferenceKind {
        MISSING("is missing"),
        EXTRA("is extra"),
        AGAIN("is drawn again"),
        ORDER("comes out of order");

        private final String said;

        DifferenceKind(String said) {
            this.said = said;
        }
    }

    /** The first difference, or none where the same pixels are drawn in the same order. */
    public static Optional<FirstDifference> of(PixelRecording exact, PixelRecording actual) {
        return of(exact, actual, PixelDifference.of(exact, actual));
    }

    /** The first difference where that of the sets is known. */
    public static Optional<FirstDifference> of(
            PixelRecording exact, PixelRecording actual, PixelDifference difference) {
        return difference.isEmpty()
                ? inOrder(exact, actual)
                : Optional.of(inPlace(exact, actual, difference));
    }

    /** The first difference between equal sets of pixels, perhaps repeated or in another order. */
    private static Optional<FirstDifference> inOrder(PixelRecording exact, PixelRecording actual) {
        int shared = Math.min(exact.size(), actual.size());
        int i = 0;
        while (i < shared && same(exact, actual, i)) i++;
        if (i == exact.size() && i == actual.size()) return Optional.empty();
        return Optional.of(
                actual.size() > exact.size()
                        ? one(DifferenceKind.AGAIN, actual, actual.firstRepeated())
                        : one(DifferenceKind.ORDER, actual, i));
    }

    private static FirstDifference inPlace(
            PixelRecording exact, PixelRecording actual, PixelDifference difference) {
        int missing = firstIn(difference.missing(), exact);
        int extra = firstIn(difference.extra(), actual);
        if (extra < missing) return one(DifferenceKind.EXTRA, actual, extra);
        if (missing < extra) return one(DifferenceKind.MISSING, exact, missing);
        return new FirstDifference(
                DifferenceKind.MISSING, pixel(exact, missing), Optional.of(pixel(actual, extra)));
    }

    private static FirstDifference one(DifferenceKind kind, PixelRecording writes, int i) {
        return new FirstDifference(kind, pixel(writes, i), Optional.empty());
    }

    private static Pixel pixel(PixelRecording writes, int i) {
        return new Pixel(writes.x(i), writes.y(i));
    }

    private static int firstIn(PixelSet set, PixelRecording writes) {
        for (int i = 0; i < writes.size(); i++)
            if (set.contains(writes.x(i), writes.y(i))) return i;
        return Integer.MAX_VALUE;
    }

    private static boolean same(PixelRecording exact, PixelRecording actual, int i) {
        return exact.x(i) == actual.x(i) && exact.y(i) == actual.y(i);
    }

    /** The difference for people, such as "pixel (1, 2) is missing, (1, 3) is drawn". */
    @Override
    public String toString() {
        String instead = drawn.map(other -> ", " + other + " is drawn").orElse("");
        return "pixel " + pixel + " " + kind.said + instead;
    }
}
