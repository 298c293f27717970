package rasterlab.app.clip.scene;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** Points of the plane as arrays of coordinates and back. */
public final class PlaneFigures {
    private PlaneFigures() {}

    /**
     * @param xy x and y of each point in turn
     */
    public static List<ClipPoint> points(double[] xy) {
        return IntStream.range(0, xy.length / 2)
                .mapToObj(i -> new ClipPoint(xy[2 * i], xy[2 * i + 1]))
                .toList();
    }

    /** x and y of each point in turn. */
    public static double[] xy(List<ClipPoint> points) {
        return points.stream().flatMapToDouble(p -> DoubleStream.of(p.x(), p.y())).toArray();
    }

    /** A closed polygon with one corner more, in the middle of the edge behind that corner. */
    static List<ClipPoint> grown(List<ClipPoint> corners, int corner) {
        ClipPoint from = corners.get(corner);
        ClipPoint to = corners.get((corner + 1) % corners.size());
        var middle = new ClipPoint((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
        return Lists.inserted(corners, corner + 1, middle);
    }
}
