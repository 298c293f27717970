package rasterlab.app.light;

import java.awt.Rectangle;

/**
 * Where the three pictures and the profile lie on the stage, in view units.
 *
 * @param width of the stage
 * @param height of the stage
 */
record StagePlan(int width, int height) {
    private static final int GAP = 6;
    private static final double PICTURES = 0.58;

    /** The picture of one of the shadings. */
    Rectangle picture(int index) {
        int wide = Math.max(1, (width - 2 * GAP) / 3);
        int high = Math.max(1, (int) (PICTURES * height));
        return new Rectangle(index * (wide + GAP), 0, wide, high);
    }

    /** The chart below them. */
    Rectangle profile() {
        int top = picture(0).height + GAP;
        return new Rectangle(0, top, width, Math.max(1, height - top));
    }

    /** The picture at a place; the nearest one in the gaps between. */
    int pictureAt(int x) {
        int wide = picture(0).width + GAP;
        return Math.max(0, Math.min(2, x / wide));
    }
}
