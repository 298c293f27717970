package rasterlab.exercises.drawing;

import java.awt.Color;
import java.util.List;
import rasterlab.engine.raster.PixelMark;

/** The colours of the pictures; form always tells the same as colour. */
final class Ink {
    static final Color PAPER = Color.WHITE;

    /** Lines of a grid or between cells. */
    static final Color GRID = new Color(0xD8DCE2);

    /** Labels, ticks, and numbers that agree: 4.5 : 1 and more on paper. */
    static final Color LABEL = new Color(0x5B6673);

    static final Color GIVEN = new Color(0x8A939E);

    /** The expected parts, and those that agree in a difference. */
    static final Color EXPECTED = new Color(0x2B3A4A);

    static final Color ACTUAL = new Color(0x0B62B8);

    static final Color MISSING = new Color(0xB3001B);
    static final Color EXTRA = PixelMark.COLOR;

    /** The most important ones first. */
    static final List<Color> ALL =
            List.of(PAPER, EXPECTED, ACTUAL, MISSING, EXTRA, LABEL, GIVEN, GRID);

    private Ink() {}

    /** The colour, so far towards paper that a figure filled with it stays readable. */
    static Color pale(Color color) {
        return towardsPaper(color, 6);
    }

    /** The colour, but not as strong as a line. */
    static Color faint(Color color) {
        return towardsPaper(color, 2);
    }

    private static Color towardsPaper(Color color, int part) {
        return new Color(
                255 - (255 - color.getRed()) / part,
                255 - (255 - color.getGreen()) / part,
                255 - (255 - color.getBlue()) / part);
    }
}
