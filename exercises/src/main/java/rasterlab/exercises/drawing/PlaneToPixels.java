package rasterlab.exercises.drawing;

import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Maps the box of a plane to the pixels of a picture: x grows right, y up or down. */
final class PlaneToPixels {
    /** The longer side of the plot, in pixels. */
    private static final int LONGEST = 420;

    /** The height of the plot where each axis has its own scale. */
    private static final int OWN_SCALES_HEIGHT = 300;

    private final PlaneBox box;
    private final boolean up;
    private final PlaneCut cut;
    private final Rectangle2D plot;

    /**
     * A plot with its upper left corner at that place of the picture.
     *
     * @param up whether y grows upwards
     */
    PlaneToPixels(PlaneBox box, boolean up, int left, int top) {
        this.box = box;
        this.up = up;
        cut = new PlaneCut(box);
        plot = new Rectangle2D.Double(left, top, width(box), height(box));
    }

    private static int width(PlaneBox box) {
        double share = box.x().half() / Math.max(box.x().half(), box.y().half());
        return box.sameScale() ? (int) Math.round(LONGEST * share) : LONGEST;
    }

    static int height(PlaneBox box) {
        double share = box.y().half() / Math.max(box.x().half(), box.y().half());
        return box.sameScale() ? (int) Math.round(LONGEST * share) : OWN_SCALES_HEIGHT;
    }

    PlaneBox box() {
        return box;
    }

    boolean isUp() {
        return up;
    }

    /** The pixels of the box. */
    Rectangle2D plot() {
        return plot;
    }

    double x(double value) {
        return plot.getX() + box.x().share(value) * plot.getWidth();
    }

    double y(double value) {
        double share = box.y().share(value);
        return plot.getY() + (up ? 1 - share : share) * plot.getHeight();
    }

    /** The place of a point in the box. */
    Point2D place(CasePoint point) {
        return new Point2D.Double(x(point.x()), y(point.y()));
    }

    /** The place next to a finite point within the plot's border. */
    Point2D nearestPlace(CasePoint point) {
        return new Point2D.Double(
                between(x(point.x()), plot.getMinX(), plot.getMaxX()),
                between(y(point.y()), plot.getMinY(), plot.getMaxY()));
    }

    /** The edges of a finite figure, so far as they lie in the box. */
    List<Line2D> strokes(PlaneFigure figure) {
        var strokes = new ArrayList<Line2D>();
        for (PlaneFigure edge : figure.edges())
            cut.segment(edge.points().get(0), edge.points().get(1))
                    .ifPresent(
                            ends ->
                                    strokes.add(
                                            new Line2D.Double(
                                                    place(ends.get(0)), place(ends.get(1)))));
        return strokes;
    }

    /** The inside of a finite polygon, so far as it lies in the box, by the even-odd rule. */
    Path2D inside(PlaneFigure polygon) {
        var path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        for (CasePoint vertex : cut.polygon(polygon.vertices())) {
            Point2D place = place(vertex);
            if (path.getCurrentPoint() == null) path.moveTo(place.getX(), place.getY());
            else path.lineTo(place.getX(), place.getY());
        }
        if (path.getCurrentPoint() != null) path.closePath();
        return path;
    }

    /** The places of those vertices that lie in the box. */
    List<Point2D> corners(PlaneFigure figure) {
        return figure.vertices().stream().filter(box::contains).map(this::place).toList();
    }

    /** Whether a part of a finite figure lies beyond the box. */
    boolean reachesBeyond(PlaneFigure figure) {
        return !figure.points().stream().allMatch(box::contains);
    }

    private static double between(double value, double low, double high) {
        return Math.max(low, Math.min(high, value));
    }
}
