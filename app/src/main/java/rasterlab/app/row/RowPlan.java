package rasterlab.app.row;

/**
 * Where on the stage the bands lie, and where the pictures of what is filtered, in view units.
 *
 * @param width of the stage
 * @param height of the stage
 * @param pictured whether there are pictures, one above the other to the right of the bands
 */
record RowPlan(int width, int height, boolean pictured) {
    static final int MARGIN = 20;

    /** The most that the column of pictures takes of the stage. */
    private static final double WIDEST = 0.34;

    /** Share of the height, so that two squares and their words fit below each other. */
    private static final double HIGHEST = 0.44;

    /** Narrower pictures show nothing. */
    private static final int NARROWEST = 64;

    /** Width of the pictures; 0 where there are none, or no room for them. */
    int column() {
        if (!pictured) return 0;
        int fit = (int) Math.min(WIDEST * (width - 2 * MARGIN), HIGHEST * (height - 2 * MARGIN));
        return fit < NARROWEST ? 0 : fit;
    }

    int columnLeft() {
        return width - MARGIN - column();
    }

    /** Whether a view x is of the pictures, not of the bands. */
    boolean inColumn(int x) {
        return column() > 0 && x >= columnLeft();
    }

    /** Width of the bands. */
    int wide() {
        return width - 2 * MARGIN - (column() == 0 ? 0 : column() + MARGIN);
    }

    /** The pixel under a view x, or the nearer end of the row. */
    int pixelAt(int x, int pixels) {
        int pixel = (int) Math.floor((x - MARGIN) * (double) pixels / wide());
        return Math.max(0, Math.min(pixels - 1, pixel));
    }
}
