package rasterlab.app.line;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.app.canvas.CoveredArea;

/** Where the label of an end stands: beside its ring, and on no lit or marked pixel. */
final class EndLabels {
    /** View units between ring and label. */
    private static final int GAP = 6;

    /** A label stands at most so many times its height farther away. */
    private static final int FARTHEST = 4;

    private EndLabels() {}

    /**
     * The place that covers the least of what is to be seen; of several the first: beyond the end,
     * towards the other one, to the left, to the right, off the ring's corners; then the same
     * farther away.
     *
     * @param ring around the end
     * @param above whether the other end lies below
     * @param within the part of the stage that labels may cover
     * @param seen what should be covered by no label
     */
    static Rectangle place(
            int width,
            int height,
            Rectangle ring,
            boolean above,
            Rectangle within,
            List<? extends Rectangle2D> seen) {
        return IntStream.rangeClosed(0, FARTHEST)
                .mapToObj(times -> GAP + times * height)
                .flatMap(gap -> around(width, height, ring, above, gap))
                .map(place -> moved(place, within))
                .min(Comparator.comparingDouble(place -> CoveredArea.of(place, seen)))
                .orElseThrow();
    }

    private static Stream<Rectangle> around(
            int width, int height, Rectangle ring, boolean above, int gap) {
        int x = ring.x + (ring.width - width) / 2;
        int y = ring.y + (ring.height - height) / 2;
        int over = ring.y - gap - height;
        int under = ring.y + ring.height + gap;
        int left = ring.x - gap - width;
        int right = ring.x + ring.width + gap;
        int beyond = above ? over : under;
        int towards = above ? under : over;
        return Stream.of(
                        new Point(x, beyond),
                        new Point(x, towards),
                        new Point(left, y),
                        new Point(right, y),
                        new Point(left, beyond),
                        new Point(right, beyond),
                        new Point(left, towards),
                        new Point(right, towards))
                .map(corner -> new Rectangle(corner.x, corner.y, width, height));
    }

    private static Rectangle moved(Rectangle place, Rectangle within) {
        int right = within.x + within.width - place.width;
        int bottom = within.y + within.height - place.height;
        return new Rectangle(
                Math.max(within.x, Math.min(right, place.x)),
                Math.max(within.y, Math.min(bottom, place.y)),
                place.width,
                place.height);
    }
}
