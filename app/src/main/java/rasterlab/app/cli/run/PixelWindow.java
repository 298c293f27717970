package rasterlab.app.cli.run;

/** The pixels [xmin, xmax] × [ymin, ymax], both ends included. y grows down. */
record PixelWindow(int xmin, int ymin, int xmax, int ymax) {
    /** Every pixel there is. */
    static final PixelWindow EVERYTHING =
            new PixelWindow(
                    Integer.MIN_VALUE, Integer.MIN_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE);

    PixelWindow {
        if (xmin > xmax)
            throw new IllegalArgumentException("xmin " + xmin + " is greater than xmax " + xmax);
        if (ymin > ymax)
            throw new IllegalArgumentException("ymin " + ymin + " is greater than ymax " + ymax);
    }

    boolean contains(int x, int y) {
        return x >= xmin && x <= xmax && y >= ymin && y <= ymax;
    }
}
