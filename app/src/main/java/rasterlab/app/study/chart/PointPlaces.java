package rasterlab.app.study;

import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.engine.study.Measurement;

/** Remembers where a chart puts its points. */
final class PointPlaces extends Annotation {
    /** How near a click must be, in pixels. */
    private static final double NEAR = 14;

    /**
     * @param x pixels from the left edge of the chart
     * @param y pixels from its upper edge
     */
    record Place(Measurement point, int x, int y) {
        double distance(int toX, int toY) {
            return Math.hypot((double) toX - x, (double) toY - y);
        }
    }

    private final List<Measurement> points;
    private final ErrorAxis errors;
    private final List<Place> places = new ArrayList<>();

    PointPlaces(List<Measurement> points) {
        super(false);
        this.points = points;
        errors = ErrorAxis.over(points);
    }

    @Override
    public void paint(Graphics2D graphics) {
        places.clear();
        for (Measurement point : points)
            places.add(
                    new Place(
                            point,
                            getXAxisScreenValue(point.cost().medianNanos()),
                            getYAxisScreenValue(errors.position(point))));
    }

    /** The points from the left, once the chart is painted. */
    List<Place> all() {
        return List.copyOf(places);
    }

    /** The nearest of them, if one is near. */
    static Optional<Place> near(List<Place> places, int x, int y) {
        return places.stream()
                .filter(place -> place.distance(x, y) <= NEAR)
                .min((a, b) -> Double.compare(a.distance(x, y), b.distance(x, y)));
    }
}
