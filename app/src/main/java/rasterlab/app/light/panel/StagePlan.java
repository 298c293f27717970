package rasterlab.app.light.panel;

import java.awt.Rectangle;

/**
 * Where the three pictures and the profile lie on the stage, in view units.
 *
 * @param width of the stage
 * @param height of the stage
 * @param line height of a line of type, of which the profile needs several
 */
public record StagePlan(int width, int height, int line) {
    private static final int GAP = 6;
    private static final double PICTURES = 0.58;

    /** Lines of type as high as the least profile: its names, its numbers, and what is around. */
    private static final int LINES = 6;

    /** The picture of one of the shadings. */
    public Rectangle picture(int index) {
        int wide = Math.max(1, (width - 2 * GAP) / 3);
        int most = Math.min((int) (PICTURES * height), height - GAP - LINES * line);
        int high = Math.max(1, most);
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
