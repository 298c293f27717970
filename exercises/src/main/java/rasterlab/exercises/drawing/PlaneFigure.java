package rasterlab.exercises.drawing;

import java.util.ArrayList;
import java.util.List;

/**
 * A figure of the plane. Its coordinates may be any doubles: what is not finite is told rather than
 * drawn.
 *
 * @param form says how the points are joined
 * @param points one of a point, two of a segment, the vertices of a polygon in order, two opposite
 *     corners of a window
 */
public record PlaneFigure(FigureKind form, List<CasePoint> points) {
    /** The kinds of figure. */
    public enum FigureKind {
        POINT,
        SEGMENT,
        POLYGON,
        /** An upright rectangle that clips; drawn without a fill. */
        WINDOW
    }

    /**
     * @throws IllegalArgumentException if the form has another number of points
     */
    public PlaneFigure {
        points = List.copyOf(points);
        int count = points.size();
        boolean right =
                switch (form) {
                    case POINT -> count == 1;
                    case SEGMENT, WINDOW -> count == 2;
                    case POLYGON -> true;
                };
        if (!right) throw new IllegalArgumentException(form + " cannot have " + count + " points");
    }

    public static PlaneFigure point(double x, double y) {
        return new PlaneFigure(FigureKind.POINT, List.of(new CasePoint(x, y)));
    }

    public static PlaneFigure segment(double x0, double y0, double x1, double y1) {
        return new PlaneFigure(
                FigureKind.SEGMENT, List.of(new CasePoint(x0, y0), new CasePoint(x1, y1)));
    }

    public static PlaneFigure window(double xmin, double ymin, double xmax, double ymax) {
        return new PlaneFigure(
                FigureKind.WINDOW, List.of(new CasePoint(xmin, ymin), new CasePoint(xmax, ymax)));
    }

    /**
     * A closed polygon of any number of vertices, none included.
     *
     * @param coordinates x and y of each vertex in turn
     * @throws IllegalArgumentException if their number is odd
     */
    public static PlaneFigure polygon(double... coordinates) {
        if (coordinates.length % 2 != 0)
            throw new IllegalArgumentException(
                    "a polygon needs x and y of each vertex, got "
                            + coordinates.length
                            + " numbers");
        var points = new ArrayList<CasePoint>();
        for (int i = 0; i < coordinates.length; i += 2)
            points.add(new CasePoint(coordinates[i], coordinates[i + 1]));
        return new PlaneFigure(FigureKind.POLYGON, points);
    }

    boolean isFinite() {
        return points.stream().allMatch(CasePoint::isFinite);
    }

    /** The vertices in order; of a window its four corners. */
    List<CasePoint> vertices() {
        if (form != FigureKind.WINDOW) return points;
        CasePoint one = points.get(0);
        CasePoint other = points.get(1);
        return List.of(
                one, new CasePoint(other.x(), one.y()), other, new CasePoint(one.x(), other.y()));
    }

    /** The vertices that each edge joins, in order; none of a point. */
    List<PlaneFigure> edges() {
        var edges = new ArrayList<PlaneFigure>();
        List<CasePoint> vertices = vertices();
        int count = form == FigureKind.POINT ? 0 : form == FigureKind.SEGMENT ? 1 : vertices.size();
        for (int i = 0; i < count; i++)
            edges.add(
                    new PlaneFigure(
                            FigureKind.SEGMENT,
                            List.of(vertices.get(i), vertices.get((i + 1) % vertices.size()))));
        return edges;
    }
}
