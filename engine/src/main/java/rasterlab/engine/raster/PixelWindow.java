package rasterlab.engine.raster;

/**
 * The pixels [xmin, xmax] × [ymin, ymax], both ends included, so at least one. x grows right, y
 * grows down.
 */
public record PixelWindow(int xmin, int ymin, int xmax, int ymax) {
    /** Every pixel there is. */
    public static final PixelWindow EVERYTHING =
            new PixelWindow(
                    Integer.MIN_VALUE, Integer.MIN_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE);

    public PixelWindow {
        if (xmin > xmax)
            throw new IllegalArgumentException(
                    "xmin must be at most xmax, got " + xmin + " > " + xmax);
        if (ymin > ymax)
            throw new IllegalArgumentException(
                    "ymin must be at most ymax, got " + ymin + " > " + ymax);
    }

    /** All pixels of a picture. */
    public static PixelWindow of(Raster picture) {
        return new PixelWindow(0, 0, picture.width() - 1, picture.height() - 1);
    }

    public boolean contains(int x, int y) {
        return x >= xmin && x <= xmax && y >= ymin && y <= ymax;
    }

    /** Number of columns, 1 to 2³². */
    public long width() {
        return (long) xmax - xmin + 1;
    }

    /** Number of rows, 1 to 2³². */
    public long height() {
        return (long) ymax - ymin + 1;
    }

    /**
     * A part of this window of at most {@code columns} × {@code rows} pixels around (x, y), moved
     * so that it stays inside.
     */
    public PixelWindow around(int x, int y, int columns, int rows) {
        long left =
                Math.min(
                        Math.max((long) x - columns / 2, xmin),
                        Math.max(xmin, (long) xmax - columns + 1));
        long top =
                Math.min(
                        Math.max((long) y - rows / 2, ymin),
                        Math.max(ymin, (long) ymax - rows + 1));
        return new PixelWindow(
                (int) left,
                (int) top,
                (int) Math.min(xmax, left + columns - 1),
                (int) Math.min(ymax, top + rows - 1));
    }
}
