package rasterlab.engine.raster;

/** The pixels with minX ≤ x ≤ maxX and minY ≤ y ≤ maxY; never empty. */
public record PixelBox(int minX, int minY, int maxX, int maxY) {
    public PixelBox {
        if (minX > maxX || minY > maxY)
            throw new IllegalArgumentException(
                    "box needs minX ≤ maxX and minY ≤ maxY, got "
                            + (minX + ".." + maxX + " × " + minY + ".." + maxY));
    }

    /** Number of columns, 1 to 2³². */
    public long width() {
        return (long) maxX - minX + 1;
    }

    /** Number of rows, 1 to 2³². */
    public long height() {
        return (long) maxY - minY + 1;
    }

    public boolean contains(int x, int y) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }

    /**
     * A part of this box of at most {@code columns} × {@code rows} pixels around (x, y), moved so
     * that it stays inside.
     */
    PixelBox around(int x, int y, int columns, int rows) {
        long left =
                Math.min(
                        Math.max((long) x - columns / 2, minX),
                        Math.max(minX, (long) maxX - columns + 1));
        long top =
                Math.min(
                        Math.max((long) y - rows / 2, minY),
                        Math.max(minY, (long) maxY - rows + 1));
        return new PixelBox(
                (int) left,
                (int) top,
                (int) Math.min(maxX, left + columns - 1),
                (int) Math.min(maxY, top + rows - 1));
    }
}
