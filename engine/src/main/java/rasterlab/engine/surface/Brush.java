package rasterlab.engine.surface;

import java.util.Arrays;

/**
 * The colour that a filled pixel gets. It depends on the pixel's place in the picture, not in the
 * figure, so neighbouring figures of one brush fit together.
 */
@FunctionalInterface
public interface Brush {
    /** Leaves the pixel as it is. */
    int CLEAR = 0;

    /** The colour of pixel (x, y), 0xAARRGGBB, or {@link #CLEAR}; any int is a place. */
    int color(int x, int y);

    /** One colour everywhere. */
    static Brush solid(int argb) {
        return (x, y) -> argb;
    }

    /** Rows {@code spacing} pixels apart, the first one at 0. */
    static Brush rows(int argb, int spacing) {
        requireSpacing(spacing);
        return (x, y) -> Math.floorMod(y, spacing) == 0 ? argb : CLEAR;
    }

    /** Columns {@code spacing} pixels apart, the first one at 0. */
    static Brush columns(int argb, int spacing) {
        requireSpacing(spacing);
        return (x, y) -> Math.floorMod(x, spacing) == 0 ? argb : CLEAR;
    }

    /** Lines falling to the right at 45°, {@code spacing} columns apart. */
    static Brush falling(int argb, int spacing) {
        requireSpacing(spacing);
        return (x, y) -> Math.floorMod((long) x - y, spacing) == 0 ? argb : CLEAR;
    }

    /** Lines rising to the right at 45°, {@code spacing} columns apart. */
    static Brush rising(int argb, int spacing) {
        requireSpacing(spacing);
        return (x, y) -> Math.floorMod((long) x + y, spacing) == 0 ? argb : CLEAR;
    }

    /**
     * A small picture, repeated from (0, 0) on in all directions.
     *
     * @param tile its colours row by row, all rows of one length, at least one pixel; copied
     */
    static Brush pattern(int[][] tile) {
        if (tile.length == 0 || tile[0].length == 0)
            throw new IllegalArgumentException(
                    "a pattern must have at least 1×1 pixel, got "
                            + (tile.length == 0 ? "no row" : "rows of no pixel"));
        for (int y = 0; y < tile.length; y++)
            if (tile[y].length != tile[0].length)
                throw new IllegalArgumentException(
                        "row %d of the pattern must have %d pixels, got %d"
                                .formatted(y, tile[0].length, tile[y].length));
        int[][] own = Arrays.stream(tile).map(int[]::clone).toArray(int[][]::new);
        return (x, y) -> own[Math.floorMod(y, own.length)][Math.floorMod(x, own[0].length)];
    }

    /** This brush, and where it leaves pixels as they are, the other. */
    default Brush over(Brush other) {
        return (x, y) -> {
            int color = color(x, y);
            return color == CLEAR ? other.color(x, y) : color;
        };
    }

    private static void requireSpacing(int spacing) {
        if (spacing < 1)
            throw new IllegalArgumentException("spacing must be at least 1 pixel, got " + spacing);
    }
}
