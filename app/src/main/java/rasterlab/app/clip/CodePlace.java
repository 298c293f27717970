package rasterlab.app.clip;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** Where in its region a code stands: as near the middle as labels leave room. */
final class CodePlace {
    /** Places tried along each side of a region: an odd number, so that the middle is one. */
    private static final int TRIED = 9;

    private CodePlace() {}

    /**
     * @param region what is seen of it, in view units
     * @param wide of the code
     * @param high of the code
     * @param labels what it may not touch
     * @return where its upper left corner goes; empty if there is no room
     */
    static Optional<Rectangle2D> of(
            Rectangle2D region, double wide, double high, List<Rectangle> labels) {
        double roomX = region.getWidth() - wide;
        double roomY = region.getHeight() - high;
        if (roomX < 0 || roomY < 0) return Optional.empty();
        double middleX = region.getX() + roomX / 2;
        double middleY = region.getY() + roomY / 2;
        return IntStream.range(0, TRIED * TRIED)
                .mapToObj(
                        i ->
                                new Rectangle2D.Double(
                                        region.getX() + roomX * (i % TRIED) / (TRIED - 1),
                                        region.getY() + roomY * (i / TRIED) / (TRIED - 1),
                                        wide,
                                        high))
                .filter(place -> labels.stream().noneMatch(place::intersects))
                .map(place -> (Rectangle2D) place)
                .min(
                        Comparator.comparingDouble(
                                place ->
                                        Math.hypot(
                                                place.getX() - middleX, place.getY() - middleY)));
    }
}
