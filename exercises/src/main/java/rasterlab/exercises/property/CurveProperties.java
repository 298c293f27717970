package rasterlab.exercises.property;

import java.util.List;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.exact.Polyline;

/** Properties of points of curves by control points. */
final class CurveProperties {
    private static final double RIGHT = 23.5;
    private static final double UP = -41.25;

    static final List<Property<CurveTask, Polyline>> ALL =
            List.of(
                    new Property<>(
                            "curve",
                            "partition-of-unity",
                            task -> task.flatness() == 0,
                            Relation.changed(
                                    CurveProperties::moved, (task, points) -> shifted(points))),
                    new Property<>(
                            "curve",
                            "hull",
                            task ->
                                    task.flatness() == 0
                                            && task.curve().kind() == Curve.Kind.BEZIER,
                            Relation.kept(CurveProperties::within)));

    private CurveProperties() {}

    /** All control points moved; of Hermite's, the derivatives are no points and stay. */
    private static CurveTask moved(CurveTask task) {
        Curve curve = task.curve();
        double[] x = curve.x().clone();
        double[] y = curve.y().clone();
        int points = curve.kind() == Curve.Kind.HERMITE ? 2 : x.length;
        for (int i = 0; i < points; i++) {
            x[i] += RIGHT;
            y[i] += UP;
        }
        return new CurveTask(new Curve(curve.kind(), x, y), task.at(), 0);
    }

    private static Polyline shifted(Polyline points) {
        Polyline shifted = new Polyline(Math.max(1, points.size()));
        for (int i = 0; i < points.size(); i++)
            shifted.point(points.x(i) + RIGHT, points.y(i) + UP);
        return shifted;
    }

    /** The points, those outside the hull brought to it. */
    private static Polyline within(CurveTask task, Polyline points) {
        ConvexHull hull = ConvexHull.of(task.curve().x(), task.curve().y());
        Polyline within = new Polyline(Math.max(1, points.size()));
        for (int i = 0; i < points.size(); i++) {
            double[] nearest = hull.nearest(points.x(i), points.y(i));
            within.point(nearest[0], nearest[1]);
        }
        return within;
    }
}
