package rasterlab.app.practice;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;

/** Points in a question's JSON. */
final class QuestionPoints {
    /** Places of a side that can be clicked. */
    private static final int SPOTS = 40;

    private QuestionPoints() {}

    /** The point [x, y, …]. */
    static Point2D of(JsonNode pair) {
        return new Point2D.Double(pair.path(0).doubleValue(), pair.path(1).doubleValue());
    }

    /** The points [[x, y], …]. */
    static List<Point2D> all(JsonNode pairs) {
        return StreamSupport.stream(pairs.spliterator(), false).map(QuestionPoints::of).toList();
    }

    /** The points [x, y, x, y, …]. */
    static List<Point2D> flat(JsonNode numbers) {
        var points = new ArrayList<Point2D>();
        for (int i = 0; i + 1 < numbers.size(); i += 2)
            points.add(
                    new Point2D.Double(
                            numbers.get(i).doubleValue(), numbers.get(i + 1).doubleValue()));
        return points;
    }

    /** The corners of the box [left, bottom, right, top]. */
    static List<Point2D> box(JsonNode sides) {
        List<Point2D> ends = flat(sides);
        Point2D low = ends.get(0);
        Point2D high = ends.get(1);
        return List.of(
                low,
                new Point2D.Double(high.getX(), low.getY()),
                high,
                new Point2D.Double(low.getX(), high.getY()));
    }

    static Point2D between(Point2D a, Point2D b, double t) {
        return new Point2D.Double(
                a.getX() + t * (b.getX() - a.getX()), a.getY() + t * (b.getY() - a.getY()));
    }

    /** Places along a path, between its corners. */
    static List<Point2D> along(List<Point2D> path, boolean closed) {
        var spots = new ArrayList<Point2D>();
        for (int i = closed ? 0 : 1; i < path.size(); i++)
            for (int k = 1; k < SPOTS; k++)
                spots.add(
                        between(
                                path.get((i + path.size() - 1) % path.size()),
                                path.get(i),
                                (double) k / SPOTS));
        return spots;
    }
}
