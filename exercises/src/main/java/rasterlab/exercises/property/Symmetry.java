package rasterlab.exercises.property;

import java.util.List;
import rasterlab.engine.raster.PixelRecording;

/**
 * A turn or mirroring about a pixel that takes octants to octants; y grows down.
 *
 * @param swapped whether the distances along x and y change places
 * @param left whether x is mirrored then
 * @param up whether y is
 */
record Symmetry(boolean swapped, boolean left, boolean up) {
    /** The symmetries of a quadrant's pixels that leave the axes in their places. */
    static final List<Symmetry> OF_QUADRANTS =
            List.of(
                    new Symmetry(false, true, false),
                    new Symmetry(false, false, true),
                    new Symmetry(false, true, true));

    /** All seven but the one that changes nothing. */
    static final List<Symmetry> OF_OCTANTS =
            List.of(
                    new Symmetry(false, true, false),
                    new Symmetry(false, false, true),
                    new Symmetry(false, true, true),
                    new Symmetry(true, false, false),
                    new Symmetry(true, true, false),
                    new Symmetry(true, false, true),
                    new Symmetry(true, true, true));

    /** A change of pixels one by one. */
    @FunctionalInterface
    interface PixelMapping {
        int[] of(int x, int y);
    }

    /** Where a pixel goes, about a centre that stays. */
    int[] of(int centerX, int centerY, int x, int y) {
        int along = swapped ? y - centerY : x - centerX;
        int down = swapped ? x - centerX : y - centerY;
        return new int[] {centerX + (left ? -along : along), centerY + (up ? -down : down)};
    }

    /** The pixels changed one by one, in their order. */
    static PixelRecording changed(PixelRecording pixels, PixelMapping change) {
        PixelRecording changed = new PixelRecording(Math.max(1, pixels.size()));
        for (int i = 0; i < pixels.size(); i++) {
            int[] at = change.of(pixels.x(i), pixels.y(i));
            changed.plot(at[0], at[1]);
        }
        return changed;
    }
}
