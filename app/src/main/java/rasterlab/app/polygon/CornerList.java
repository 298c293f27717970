package rasterlab.app.polygon;

import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import rasterlab.engine.polygon.Points;

/** Changed copies of a polygon's corners. */
final class CornerList {
    /** Corners the lab can show at once. */
    static final int MOST = 60;

    private CornerList() {}

    static List<Place> of(Points points) {
        return IntStream.range(0, points.size())
                .mapToObj(i -> new Place(points.x(i), points.y(i)))
                .toList();
    }

    static List<Place> of(double... xy) {
        return of(Points.of(xy));
    }

    /**
     * @throws IllegalArgumentException naming the first place that is not finite
     */
    static Points points(List<Place> places) {
        return new Points(
                places.stream().mapToDouble(Place::x).toArray(),
                places.stream().mapToDouble(Place::y).toArray());
    }

    static Map<Grip, Place> grips(List<Place> corners) {
        var grips = new LinkedHashMap<Grip, Place>();
        if (corners.size() <= MOST)
            for (int i = 0; i < corners.size(); i++) grips.put(Grip.corner(i), corners.get(i));
        return grips;
    }

    static List<Place> replaced(List<Place> corners, int index, Place place) {
        var copy = new ArrayList<>(corners);
        copy.set(index, place);
        return List.copyOf(copy);
    }

    /** One more in the middle of the edge behind that corner; the same where there are enough. */
    static List<Place> grown(List<Place> corners, int corner) {
        Place from = corners.get(corner);
        Place to = corners.get((corner + 1) % corners.size());
        return inserted(
                corners, corner, new Place((from.x() + to.x()) / 2, (from.y() + to.y()) / 2));
    }

    /** One more there, between the ends of the edge that is nearest. */
    static List<Place> joined(List<Place> corners, Place at) {
        int nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < corners.size(); i++) {
            Place from = corners.get(i);
            Place to = corners.get((i + 1) % corners.size());
            double away = Line2D.ptSegDist(from.x(), from.y(), to.x(), to.y(), at.x(), at.y());
            if (away < least) {
                least = away;
                nearest = i;
            }
        }
        return inserted(corners, nearest, at);
    }

    private static List<Place> inserted(List<Place> corners, int behind, Place place) {
        if (corners.size() >= MOST) return corners;
        var copy = new ArrayList<>(corners);
        copy.add(behind + 1, place);
        return List.copyOf(copy);
    }

    /** The corners without that one; the same where only {@code least} are left. */
    static List<Place> removed(List<Place> corners, int index, int least) {
        if (corners.size() <= least) return corners;
        var copy = new ArrayList<>(corners);
        copy.remove(index);
        return List.copyOf(copy);
    }
}
