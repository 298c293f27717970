package rasterlab.app.study.chart;

import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.engine.study.Measurement;

/** Remembers where a chart puts its points. */
final class PointPlaces extends Annotation {
    /**
     * @param x pixels from the left edge of the chart
     * @param y pixels from its upper edge
     */
    record Place(Measurement point, int x, int y) {}

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
}
