package rasterlab.app.polygon.figure;

import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import rasterlab.engine.polygon.Points;

/** Changed copies of a polygon's corners. */
public final class CornerList {
    /** Corners the lab can show at once. */
    static final int MOST = 60;

    private CornerList() {}

    public static List<PolygonPoint> of(Points points) {
        return IntStream.range(0, points.size())
                .mapToObj(i -> new PolygonPoint(points.x(i), points.y(i)))
                .toList();
    }

    public static List<PolygonPoint> of(double... xy) {
        return of(Points.of(xy));
    }

    /**
     * @throws IllegalArgumentException naming the first place that is not finite
     */
    public static Points points(List<PolygonPoint> places) {
        return new Points(
                places.stream().mapToDouble(PolygonPoint::x).toArray(),
                places.stream().mapToDouble(PolygonPoint::y).toArray());
    }

    static Map<Grip, PolygonPoint> grips(List<PolygonPoint> corners) {
        var grips = new LinkedHashMap<Grip, PolygonPoint>();
        if (corners.size() <= MOST)
            for (int i = 0; i < corners.size(); i++) grips.put(Grip.corner(i), corners.get(i));
        return grips;
    }

    static List<PolygonPoint> replaced(List<PolygonPoint> corners, int index, PolygonPoint place) {
        var copy = new ArrayList<>(corners);
        copy.set(index, place);
        return List.copyOf(copy);
    }

    /** One more in the middle of the edge behind that corner; the same where there are enough. */
    static List<PolygonPoint> grown(List<PolygonPoint> corners, int corner) {
        PolygonPoint from = corners.get(corner);
        PolygonPoint to = corners.get((corner + 1) % corners.size());
        return inserted(
                corners,
                corner,
                new PolygonPoint((from.x() + to.x()) / 2, (from.y() + to.y()) / 2));
    }

    /** One more there, between the ends of the edge that is nearest. */
    static List<PolygonPoint> joined(List<PolygonPoint> corners, PolygonPoint at) {
        int nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < corners.size(); i++) {
            PolygonPoint from = corners.get(i);
            PolygonPoint to = corners.get((i + 1) % corners.size());
            double away = Line2D.ptSegDist(from.x(), from.y(), to.x(), to.y(), at.x(), at.y());
            if (away < least) {
                least = away;
                nearest = i;
            }
        }
        return inserted(corners, nearest, at);
    }

    private static List<PolygonPoint> inserted(
            List<PolygonPoint> corners, int behind, PolygonPoint place) {
        if (corners.size() >= MOST) return corners;
        var copy = new ArrayList<>(corners);
        copy.add(behind + 1, place);
        return List.copyOf(copy);
    }

    /** The corners without that one; the same where only {@code least} are left. */
    static List<PolygonPoint> removed(List<PolygonPoint> corners, int index, int least) {
        if (corners.size() <= least) return corners;
        var copy = new ArrayList<>(corners);
        copy.remove(index);
        return List.copyOf(copy);
    }
}
