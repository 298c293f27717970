package rasterlab.app.spline;

import java.util.List;
import rasterlab.engine.range.Bounds;

/**
 * The box around points; places without a number do not count.
 *
 * @param width not negative
 * @param height not negative
 */
public record Extent(double x, double y, double width, double height) {
    private static final double LARGEST = 1e200;

    public Extent {
        Bounds.requireAtLeast("width", width, 0);
        Bounds.requireAtLeast("height", height, 0);
    }

    static Extent of(List<Place> places) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (Place place : places) {
            if (Double.isNaN(place.x()) || Double.isNaN(place.y())) continue;
            left = Math.min(left, clamped(place.x()));
            right = Math.max(right, clamped(place.x()));
            low = Math.min(low, clamped(place.y()));
            high = Math.max(high, clamped(place.y()));
        }
        if (left > right) return new Extent(0, 0, 0, 0);
        return new Extent(left, low, right - left, high - low);
    }

    private static double clamped(double coordinate) {
        return Math.max(-LARGEST, Math.min(LARGEST, coordinate));
    }

    public double diagonal() {
        return Math.hypot(width, height);
    }
}
