package rasterlab.app.polygon;

import java.awt.FontMetrics;
import java.awt.Rectangle;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.app.canvas.ReadOut;
import rasterlab.app.canvas.Wrapping;

/**
 * Words in a corner of a view, which has buttons in the lower right one and a {@link ReadOut} in
 * the lower left one.
 *
 * @param place of all lines
 */
record CornerWords(List<String> lines, Rectangle place) {
    /** Share of the width that the buttons leave. */
    private static final double BESIDE_BUTTONS = 0.6;

    /** View units between the words and the view's edges. */
    private static final int EDGE = 12;

    private static final int ABOVE_READ_OUT = 3;

    /**
     * The words to the lower left above the read-out, or in an upper corner where they cover less
     * there.
     *
     * @param taken what they should not cover
     */
    static CornerWords of(String said, Rectangle view, FontMetrics metrics, List<Rectangle> taken) {
        int room = (int) (BESIDE_BUTTONS * view.width);
        List<String> lines = Wrapping.lines(said, room, metrics::stringWidth);
        int wide = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        int high = lines.size() * metrics.getHeight();
        int left = view.x + EDGE;
        int right = view.x + view.width - EDGE - wide;
        int upper = view.y + EDGE;
        int lower = view.y + view.height - ReadOut.reach(metrics) - ABOVE_READ_OUT - high;
        return Stream.of(
                        new Rectangle(left, lower, wide, high),
                        new Rectangle(left, upper, wide, high),
                        new Rectangle(right, upper, wide, high))
                .min(Comparator.comparingInt(place -> covered(place, taken)))
                .map(place -> new CornerWords(lines, place))
                .orElseThrow();
    }

    private static int covered(Rectangle place, List<Rectangle> taken) {
        return taken.stream()
                .map(place::intersection)
                .filter(both -> !both.isEmpty())
                .mapToInt(both -> both.width * both.height)
                .sum();
    }
}
