package rasterlab.app.line.figure;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.LinkedHashMap;
import java.util.Map;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.Ellipse;

/**
 * A circle or an ellipse in whole pixels.
 *
 * @param round whether both half-axes are the radius of a circle
 */
public record ArcFigure(
        boolean round,
        @JsonProperty("centreX") int centerX,
        @JsonProperty("centreY") int centerY,
        int radiusX,
        int radiusY)
        implements DrawnFigure {
    static final String CENTER = "grip.centre";
    static final String RADIUS_X = "grip.radiusX";
    static final String RADIUS_Y = "grip.radiusY";

    static ArcFigure of(Circle circle) {
        return new ArcFigure(
                true, circle.centerX(), circle.centerY(), circle.radius(), circle.radius());
    }

    static ArcFigure of(Ellipse ellipse) {
        return new ArcFigure(
                false, ellipse.centerX(), ellipse.centerY(), ellipse.radiusX(), ellipse.radiusY());
    }

    Circle circle() {
        return new Circle(centerX, centerY, radiusX);
    }

    Ellipse ellipse() {
        return new Ellipse(centerX, centerY, radiusX, radiusY);
    }

    /**
     * The figure with that half-axis along the rows, and along the columns too where it is a
     * circle.
     */
    public ArcFigure withRadiusX(int radius) {
        return new ArcFigure(round, centerX, centerY, radius, round ? radius : radiusY);
    }

    public ArcFigure withRadiusY(int radius) {
        return new ArcFigure(round, centerX, centerY, round ? radius : radiusX, radius);
    }

    public ArcFigure withCenter(int x, int y) {
        return new ArcFigure(round, x, y, radiusX, radiusY);
    }

    @Override
    public Map<String, RasterPoint> grips() {
        var grips = new LinkedHashMap<String, RasterPoint>();
        grips.put(RADIUS_X, new RasterPoint((double) centerX + radiusX, centerY));
        if (!round) grips.put(RADIUS_Y, new RasterPoint(centerX, (double) centerY + radiusY));
        grips.put(CENTER, new RasterPoint(centerX, centerY));
        return grips;
    }

    @Override
    public ArcFigure moved(String grip, RasterPoint to) {
        return switch (grip) {
            case RADIUS_X -> withRadiusX(whole(Math.abs(to.x() - centerX)));
            case RADIUS_Y -> withRadiusY(whole(Math.abs(to.y() - centerY)));
            default -> withCenter(whole(to.x()), whole(to.y()));
        };
    }

    /** The nearest int. */
    private static int whole(double value) {
        return (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, Math.rint(value)));
    }
}
