package rasterlab.engine.raster;

/** The pixels [xmin, xmax] × [ymin, ymax], both ends included. x grows right, y grows down. */
public record PixelWindow(int xmin, int ymin, int xmax, int ymax) {
    /** Every pixel there is. */
    public static final PixelWindow EVERYTHING =
            new PixelWindow(
                    Integer.MIN_VALUE, Integer.MIN_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE);

    public PixelWindow {
        if (xmin > xmax)
            throw new IllegalArgumentException("xmin " + xmin + " is greater than xmax " + xmax);
        if (ymin > ymax)
            throw new IllegalArgumentException("ymin " + ymin + " is greater than ymax " + ymax);
    }

    /** All pixels of a picture. */
    public static PixelWindow of(Raster picture) {
        return new PixelWindow(0, 0, picture.width() - 1, picture.height() - 1);
    }

    public boolean contains(int x, int y) {
        return x >= xmin && x <= xmax && y >= ymin && y <= ymax;
    }
}
