package rasterlab.engine.border;

import java.util.List;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.polygon.inside.PointInPolygonTopic;
import rasterlab.engine.polygon.triangle.PointInTriangleTopic;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;

/** Points of the plane and the shapes they are held against. */
final class PlaneBorders {
    private static final TriangulateTopic TRIANGULATE = new TriangulateTopic();

    private PlaneBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(new PointInTriangleTopic(), draws -> shape(draws, 3)),
                Border.of(new PointInPolygonTopic(), draws -> shape(draws, 3 + draws.pick(4))),
                Border.of(
                        TRIANGULATE,
                        draws -> points(draws, 3 + draws.pick(3)),
                        (method, corners, message) -> noInside(corners)));
    }

    private static ShapeAndPoints shape(Draws draws, int corners) {
        Points shape = points(draws, corners);
        return new ShapeAndPoints(shape, points(draws, 1 + draws.pick(2)));
    }

    static Points points(Draws draws, int count) {
        return Points.of(coordinates(draws, count));
    }

    /** x and y of points, some of them midway between the two before, or as near as doubles are. */
    static double[] coordinates(Draws draws, int points) {
        var xy = new double[2 * points];
        for (int i = 0; i < points; i++) {
            int kind = i < 2 ? 0 : draws.pick(6);
            for (int at = 2 * i; at < 2 * i + 2; at++)
                xy[at] = kind == 5 ? xy[at - 4] / 2 + xy[at - 2] / 2 : draws.number();
        }
        return xy;
    }

    private static boolean noInside(Points corners) {
        return TRIANGULATE.exact(corners, 1).size() == 0;
    }
}
