package rasterlab.app.line;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.Comparator;
import java.util.List;

/** Where the label of an end stands: beside its ring, and on no marked pixel. */
final class EndLabels {
    /** View units between ring and label. */
    private static final int GAP = 6;

    private EndLabels() {}

    /**
     * The place that covers the least of what is to be seen; of several the first: beyond the end,
     * towards the other one, to the left, to the right.
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
        int x = ring.x + (ring.width - width) / 2;
        int y = ring.y + (ring.height - height) / 2;
        int over = ring.y - GAP - height;
        int under = ring.y + ring.height + GAP;
        return List.of(
                        new Rectangle(x, above ? over : under, width, height),
                        new Rectangle(x, above ? under : over, width, height),
                        new Rectangle(ring.x - GAP - width, y, width, height),
                        new Rectangle(ring.x + ring.width + GAP, y, width, height))
                .stream()
                .map(place -> moved(place, within))
                .min(Comparator.comparingDouble(place -> covered(place, seen)))
                .orElseThrow();
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

    private static double covered(Rectangle place, List<? extends Rectangle2D> seen) {
        double area = 0;
        for (Rectangle2D each : seen) {
            Rectangle2D both = each.createIntersection(place);
            if (!both.isEmpty()) area += both.getWidth() * both.getHeight();
        }
        return area;
    }
}
