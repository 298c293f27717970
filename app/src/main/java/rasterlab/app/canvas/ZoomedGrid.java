package rasterlab.app.canvas;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;

/**
 * Where a zoomed pixel grid lies in the stage.
 *
 * <p>The pixel (x, y) covers the view square of {@code cell} units whose centre is {@code view =
 * origin + cell · pixel}; both y axes grow down.
 *
 * @param originX view x of the centre of pixel column 0
 * @param originY view y of the centre of pixel row 0
 * @param cell view units per pixel, in [{@link #SMALLEST}, {@link #LARGEST}]
 */
public record ZoomedGrid(double originX, double originY, double cell) {
    public static final double SMALLEST = 0.25;
    public static final double LARGEST = 96;

    /** The number of view units beyond which Java2D's own clipping loses precision. */
    private static final double FAR = 1e5;

    public ZoomedGrid {
        if (!(cell >= SMALLEST && cell <= LARGEST))
            throw new IllegalArgumentException(
                    "cell must be in [" + SMALLEST + ", " + LARGEST + "], got " + cell);
    }

    /**
     * The grid that shows {@code pixels} whole and centred in a view of that size.
     *
     * @param pixels bounds in pixels, counted from 0; at least 1×1
     */
    public static ZoomedGrid fitting(Rectangle pixels, Rectangle view) {
        double cell = Math.min(view.getWidth() / pixels.width, view.getHeight() / pixels.height);
        cell = clamp(cell >= 2 ? Math.floor(cell) : cell);
        return new ZoomedGrid(
                view.getCenterX() - cell * (pixels.x + (pixels.width - 1) / 2.0),
                view.getCenterY() - cell * (pixels.y + (pixels.height - 1) / 2.0),
                cell);
    }

    public double viewX(double pixelX) {
        return originX + cell * pixelX;
    }

    public double viewY(double pixelY) {
        return originY + cell * pixelY;
    }

    /**
     * The view line between the centres of two pixels. Of one longer than {@value #FAR} view units
     * only the stretch is given that lies within so many of the point nearest to view (0, 0).
     */
    public Line2D line(int pixelX0, int pixelY0, int pixelX1, int pixelY1) {
        double x = viewX(pixelX0);
        double y = viewY(pixelY0);
        double length = Math.hypot(viewX(pixelX1) - x, viewY(pixelY1) - y);
        if (length <= FAR) return new Line2D.Double(x, y, viewX(pixelX1), viewY(pixelY1));
        double dx = (viewX(pixelX1) - x) / length;
        double dy = (viewY(pixelY1) - y) / length;
        double near = Math.max(0, Math.min(length, -(x * dx + y * dy)));
        double from = Math.max(0, near - FAR);
        double to = Math.min(length, near + FAR);
        return new Line2D.Double(x + dx * from, y + dy * from, x + dx * to, y + dy * to);
    }

    /** The pixel whose square holds that view point. */
    public Point pixelAt(double viewX, double viewY) {
        return new Point(nearest((viewX - originX) / cell), nearest((viewY - originY) / cell));
    }

    /** Zooms by a factor about a view point, which keeps its place; stops at the cell's range. */
    public ZoomedGrid zoomed(double factor, Point2D view) {
        double next = clamp(cell * factor);
        double scale = next / cell;
        return new ZoomedGrid(
                view.getX() + (originX - view.getX()) * scale,
                view.getY() + (originY - view.getY()) * scale,
                next);
    }

    public ZoomedGrid moved(double viewDx, double viewDy) {
        return new ZoomedGrid(originX + viewDx, originY + viewDy, cell);
    }

    private static int nearest(double value) {
        return (int) Math.floor(value + 0.5);
    }

    private static double clamp(double cell) {
        return Math.max(SMALLEST, Math.min(LARGEST, cell));
    }
}
