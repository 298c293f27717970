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
public record PlaneFigure(Form form, List<PlanePoint> points) {
    /** The kinds of figure. */
    public enum Form {
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
        return new PlaneFigure(Form.POINT, List.of(new PlanePoint(x, y)));
    }

    public static PlaneFigure segment(double x0, double y0, double x1, double y1) {
        return new PlaneFigure(
                Form.SEGMENT, List.of(new PlanePoint(x0, y0), new PlanePoint(x1, y1)));
    }

    public static PlaneFigure window(double xmin, double ymin, double xmax, double ymax) {
        return new PlaneFigure(
                Form.WINDOW, List.of(new PlanePoint(xmin, ymin), new PlanePoint(xmax, ymax)));
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
        var points = new ArrayList<PlanePoint>();
        for (int i = 0; i < coordinates.length; i += 2)
            points.add(new PlanePoint(coordinates[i], coordinates[i + 1]));
        return new PlaneFigure(Form.POLYGON, points);
    }

    boolean isFinite() {
        return points.stream().allMatch(PlanePoint::isFinite);
    }

    /** The vertices in order; of a window its four corners. */
    List<PlanePoint> vertices() {
        if (form != Form.WINDOW) return points;
        PlanePoint one = points.get(0);
        PlanePoint other = points.get(1);
        return List.of(
                one, new PlanePoint(other.x(), one.y()), other, new PlanePoint(one.x(), other.y()));
    }

    /** The vertices that each edge joins, in order; none of a point. */
    List<PlaneFigure> edges() {
        var edges = new ArrayList<PlaneFigure>();
        List<PlanePoint> vertices = vertices();
        int count = form == Form.POINT ? 0 : form == Form.SEGMENT ? 1 : vertices.size();
        for (int i = 0; i < count; i++)
            edges.add(
                    new PlaneFigure(
                            Form.SEGMENT,
                            List.of(vertices.get(i), vertices.get((i + 1) % vertices.size()))));
        return edges;
    }
}
