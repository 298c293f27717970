package rasterlab.engine.raster;

import rasterlab.engine.study.Deviation;

/** How far a drawn figure is from the exact one, as sets of pixels in any order. */
public final class SetComparison {
    /** How far off, in pixels, a missing or an extra pixel may lie in a usable figure. */
    public static final double USABLE_PIXELS = 1;

    private SetComparison() {}

    public static Deviation compare(PixelRecording exact, PixelRecording actual) {
        PixelDifference difference = PixelDifference.of(exact, actual);
        PixelSet missing = difference.missing();
        PixelSet extra = difference.extra();
        return new Deviation(
                difference.worst(exact, actual),
                missing.size(),
                extra.size() + repeated(actual),
                exact.size(),
                first(difference, actual));
    }

    private static long repeated(PixelRecording actual) {
        return actual.size() - PixelSet.of(actual).size();
    }

    private static String first(PixelDifference difference, PixelRecording actual) {
        if (!difference.missing().isEmpty()) return pixel(difference.missing(), "missing");
        if (!difference.extra().isEmpty()) return pixel(difference.extra(), "extra");
        long repeated = repeated(actual);
        return repeated == 0 ? "" : repeated + " pixels are drawn again";
    }

    private static String pixel(PixelSet set, String what) {
        return "pixel (" + set.x(0) + ", " + set.y(0) + ") is " + what;
    }
}
