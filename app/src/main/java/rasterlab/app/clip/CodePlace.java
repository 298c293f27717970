package rasterlab.app.clip;

import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** Where in its region a code stands: as near the middle as labels and segments leave room. */
final class CodePlace {
    /** View units between a code and what it may not touch: half of a thick line, and a gap. */
    static final double GAP = 6;

    /** Places tried along each side of a region: an odd number, so that the middle is one. */
    private static final int TRIED = 25;

    private final Rectangle2D region;
    private final List<Rectangle> labels;
    private final List<Line2D> segments;

    /**
     * @param seen of the region, in view units
     * @param labels which a code may not touch
     * @param segments which it may not touch either
     */
    CodePlace(Rectangle2D seen, List<Rectangle> labels, List<Line2D> segments) {
        region = grown(seen, -GAP);
        this.labels = labels.stream().filter(seen::intersects).toList();
        this.segments = segments.stream().filter(seen::intersectsLine).toList();
    }

    /**
     * @param wide of the code
     * @param high of the code
     * @return its bounds; empty if there is no room
     */
    Optional<Rectangle2D> of(double wide, double high) {
        double roomX = region.getWidth() - wide;
        double roomY = region.getHeight() - high;
        if (roomX < 0 || roomY < 0) return Optional.empty();
        double middleX = region.getX() + roomX / 2;
        double middleY = region.getY() + roomY / 2;
        return IntStream.range(0, TRIED * TRIED)
                .mapToObj(
                        i ->
                                (Rectangle2D)
                                        new Rectangle2D.Double(
                                                region.getX() + roomX * (i % TRIED) / (TRIED - 1),
                                                region.getY() + roomY * (i / TRIED) / (TRIED - 1),
                                                wide,
                                                high))
                .sorted(
                        Comparator.comparingDouble(
                                place ->
                                        Math.hypot(place.getX() - middleX, place.getY() - middleY)))
                .filter(this::free)
                .findFirst();
    }

    private boolean free(Rectangle2D place) {
        Rectangle2D around = grown(place, GAP);
        return labels.stream().noneMatch(grown(place, GAP / 2)::intersects)
                && segments.stream().noneMatch(around::intersectsLine);
    }

    private static Rectangle2D grown(Rectangle2D box, double by) {
        return new Rectangle2D.Double(
                box.getX() - by,
                box.getY() - by,
                box.getWidth() + 2 * by,
                box.getHeight() + 2 * by);
    }
}
