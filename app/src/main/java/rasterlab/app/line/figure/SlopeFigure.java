package rasterlab.app.line.figure;

import java.util.Map;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.engine.line.Segment;

/**
 * Lines from one pixel in all directions of a quadrant, and one of them.
 *
 * @param degrees of that one to the rows, a whole number in 0..90
 */
public record SlopeFigure(int degrees) implements DrawnFigure {
    /** Length of each line in pixels, about. */
    private static final int LENGTH = 200;

    static final String ANGLE = "grip.angle";
    static final int STEEPEST = 90;

    /** The line at that angle. */
    static Segment segment(int degrees) {
        double angle = Math.toRadians(degrees);
        return new Segment(
                0,
                0,
                (int) Math.rint(LENGTH * Math.cos(angle)),
                (int) Math.rint(LENGTH * Math.sin(angle)));
    }

    /** Light for a pixel of length that a line of full pixels gets: one in each column or row. */
    public static double ofFullPixels(int degrees) {
        double angle = Math.toRadians(degrees);
        return Math.max(Math.cos(angle), Math.sin(angle));
    }

    @Override
    public Map<String, RasterPoint> grips() {
        return Map.of(ANGLE, new RasterPoint(degrees, ofFullPixels(degrees)));
    }

    @Override
    public SlopeFigure moved(String grip, RasterPoint to) {
        return new SlopeFigure((int) Math.max(0, Math.min(STEEPEST, Math.rint(to.x()))));
    }
}
