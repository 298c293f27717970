package rasterlab.engine.texture;

/**
 * A level of a repeated texture whose sides are powers of two.
 *
 * @param argb texels row by row, the bottom row first: not a copy
 * @param across logarithm of the number of columns
 * @param up logarithm of the number of rows
 */
record RepeatedLevel(int[] argb, int across, int up) {
    static RepeatedLevel of(TextureLevel level) {
        return new RepeatedLevel(
                level.argb(),
                Integer.numberOfTrailingZeros(level.width()),
                Integer.numberOfTrailingZeros(level.height()));
    }

    int lastColumn() {
        return (1 << across) - 1;
    }

    int lastRow() {
        return (1 << up) - 1;
    }
}
