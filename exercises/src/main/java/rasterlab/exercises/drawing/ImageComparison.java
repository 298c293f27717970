package rasterlab.exercises.drawing;

import java.util.Optional;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.Raster;

/**
 * Two images of one size, held against each other channel by channel. Two pixels that are wholly
 * transparent agree whatever their colors.
 */
final class ImageComparison {
    private static final int CHANNEL = 8;

    private final Raster expected;
    private final Raster actual;
    private final int tolerance;
    private final Optional<Pixel> first;
    private final int count;

    /**
     * @param tolerance levels by which a channel of a right pixel may differ, from 0
     * @throws IllegalArgumentException if the sizes differ or the tolerance is negative
     */
    ImageComparison(Raster expected, Raster actual, int tolerance) {
        if (expected.width() != actual.width() || expected.height() != actual.height())
            throw new IllegalArgumentException(
                    "images of one size are compared, got %d×%d expected and %d×%d actual"
                            .formatted(
                                    expected.width(),
                                    expected.height(),
                                    actual.width(),
                                    actual.height()));
        if (tolerance < 0)
            throw new IllegalArgumentException("tolerance must be at least 0, got " + tolerance);
        this.expected = expected;
        this.actual = actual;
        this.tolerance = tolerance;
        int[] wanted = expected.argb();
        int[] got = actual.argb();
        int found = -1;
        int wrong = 0;
        for (int i = 0; i < wanted.length; i++)
            if (levels(wanted[i], got[i]) > 0) {
                if (wrong == 0) found = i;
                wrong++;
            }
        count = wrong;
        first =
                wrong == 0
                        ? Optional.empty()
                        : Optional.of(
                                new Pixel(found % expected.width(), found / expected.width()));
    }

    /** Levels by which the channel differs that differs most, 0 to 255; 0 for a right pixel. */
    int wrong(int x, int y) {
        return levels(expected.argb(x, y), actual.argb(x, y));
    }

    private int levels(int wanted, int got) {
        if (wanted == got || wanted >>> 24 == 0 && got >>> 24 == 0) return 0;
        int most = 0;
        for (int shift = 0; shift < Integer.SIZE; shift += CHANNEL)
            most = Math.max(most, Math.abs((wanted >>> shift & 255) - (got >>> shift & 255)));
        return most > tolerance ? most : 0;
    }

    /** The first wrong pixel, row by row. */
    Optional<Pixel> first() {
        return first;
    }

    /** Number of wrong pixels. */
    int count() {
        return count;
    }
}
