package rasterlab.engine.line;

import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.study.Deviation;

/**
 * How far a drawn line is from the exact one, as sets of pixels.
 *
 * <p>The worst error is the larger of two distances, each max(|Δx|, |Δy|): from any exact pixel to
 * the nearest drawn one (so gaps count) and from any drawn pixel to the nearest exact one. Where
 * nothing is drawn it is the number of exact pixels. Right pixels that come twice or out of order
 * are no distance away, but still a difference.
 */
final class LineComparison {
    private LineComparison() {}

    static Deviation compare(PixelRecording exact, PixelRecording actual) {
        PixelDifference difference = PixelDifference.of(exact, actual);
        PixelSet missing = difference.missing();
        PixelSet extra = difference.extra();
        return new Deviation(
                difference.worst(exact, actual),
                missing.size(),
                extra.size(),
                exact.size(),
                difference.isEmpty() ? order(exact, actual) : first(exact, actual, difference));
    }

    /** The same pixels, but perhaps repeated or in another order. */
    private static String order(PixelRecording exact, PixelRecording actual) {
        int shared = Math.min(exact.size(), actual.size());
        int i = 0;
        while (i < shared && same(exact, actual, i)) i++;
        if (i == exact.size() && i == actual.size()) return "";
        return actual.size() > exact.size()
                ? pixel(actual, actual.firstRepeated()) + " is drawn again"
                : pixel(actual, i) + " comes out of order";
    }

    private static String first(
            PixelRecording exact, PixelRecording actual, PixelDifference difference) {
        int missing = firstIn(difference.missing(), exact);
        int extra = firstIn(difference.extra(), actual);
        if (missing == extra)
            return pixel(exact, missing) + " is missing, " + place(actual, extra) + " is drawn";
        return missing < extra
                ? pixel(exact, missing) + " is missing"
                : pixel(actual, extra) + " is extra";
    }

    private static int firstIn(PixelSet set, PixelRecording writes) {
        for (int i = 0; i < writes.size(); i++)
            if (set.contains(writes.x(i), writes.y(i))) return i;
        return Integer.MAX_VALUE;
    }

    private static boolean same(PixelRecording exact, PixelRecording actual, int i) {
        return exact.x(i) == actual.x(i) && exact.y(i) == actual.y(i);
    }

    private static String pixel(PixelRecording writes, int i) {
        return "pixel " + place(writes, i);
    }

    private static String place(PixelRecording writes, int i) {
        return "(" + writes.x(i) + ", " + writes.y(i) + ")";
    }
}
