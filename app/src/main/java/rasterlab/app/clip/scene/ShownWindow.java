package rasterlab.app.clip.scene;

import java.util.List;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.segment.ClipWindow;

/**
 * The window: an upright rectangle, or any polygon, which methods refuse unless it is convex.
 *
 * @param corners of a rectangle (xmin, ymin), (xmax, ymin), (xmax, ymax), (xmin, ymax)
 */
public record ShownWindow(List<ClipPoint> corners, boolean upright) {
    /** Corners of a convex polygon as shares of a rectangle's width and height. */
    private static final double[] HEXAGON = {
        0.25, 0, 0.8, 0.05, 1, 0.5, 0.7, 1, 0.15, 0.9, 0, 0.35
    };

    public ShownWindow {
        corners = List.copyOf(corners);
        if (upright && corners.size() != 4)
            throw new IllegalArgumentException(
                    "corners of a rectangle must be 4, got " + corners.size());
    }

    public static ShownWindow of(ClipWindow sides) {
        return new ShownWindow(
                PlaneFigures.points(
                        PolygonInWindow.rectangle(
                                sides.xmin(), sides.ymin(), sides.xmax(), sides.ymax())),
                true);
    }

    /**
     * @param xy x and y of each corner in turn
     */
    static ShownWindow of(double[] xy) {
        List<ClipPoint> corners = PlaneFigures.points(xy);
        ShownWindow around = of(around(corners));
        return corners.equals(around.corners) ? around : new ShownWindow(corners, false);
    }

    /** The rectangle, or the smallest one around the polygon. */
    public ClipWindow rectangle() {
        return around(corners);
    }

    private static ClipWindow around(List<ClipPoint> corners) {
        return new ClipWindow(
                corners.stream().mapToDouble(ClipPoint::x).min().orElseThrow(),
                corners.stream().mapToDouble(ClipPoint::y).min().orElseThrow(),
                corners.stream().mapToDouble(ClipPoint::x).max().orElseThrow(),
                corners.stream().mapToDouble(ClipPoint::y).max().orElseThrow());
    }

    public double[] xy() {
        return PlaneFigures.xy(corners);
    }

    /** The window with a corner elsewhere; that of a rectangle stops at the sides it is not on. */
    ShownWindow moved(int corner, ClipPoint to) {
        if (!upright) return new ShownWindow(Lists.replaced(corners, corner, to), false);
        ClipWindow now = rectangle();
        boolean left = corner == 0 || corner == 3;
        boolean bottom = corner < 2;
        return of(
                new ClipWindow(
                        left ? Math.min(to.x(), now.xmax()) : now.xmin(),
                        bottom ? Math.min(to.y(), now.ymax()) : now.ymin(),
                        left ? now.xmax() : Math.max(to.x(), now.xmin()),
                        bottom ? now.ymax() : Math.max(to.y(), now.ymin())));
    }

    /** The window with one corner more, behind that one; a rectangle stays as it is. */
    ShownWindow grown(int corner) {
        if (upright) return this;
        return new ShownWindow(PlaneFigures.grown(corners, corner), false);
    }

    /** The window without that corner; a rectangle and a triangle stay as they are. */
    ShownWindow without(int corner) {
        if (upright || corners.size() == 3) return this;
        return new ShownWindow(Lists.removed(corners, corner), false);
    }

    /** The rectangle around it, or a convex polygon in the rectangle. */
    ShownWindow shaped(boolean asRectangle) {
        if (asRectangle == upright) return this;
        ClipWindow sides = rectangle();
        if (asRectangle) return of(sides);
        var corners = new double[HEXAGON.length];
        for (int i = 0; i < corners.length; i += 2) {
            corners[i] = sides.xmin() + HEXAGON[i] * (sides.xmax() - sides.xmin());
            corners[i + 1] = sides.ymin() + HEXAGON[i + 1] * (sides.ymax() - sides.ymin());
        }
        return new ShownWindow(PlaneFigures.points(corners), false);
    }
}
