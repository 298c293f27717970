package rasterlab.app.polygon.figure;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rasterlab.engine.polygon.ShapeAndPoints;

/**
 * A polygon and points to judge by it.
 *
 * @param triangle whether it always has three corners
 * @param points the first one is judged step by step
 * @param whole whether only points with whole coordinates are looked at
 */
public record InsideFigure(
        boolean triangle, List<PolygonPoint> corners, List<PolygonPoint> points, boolean whole)
        implements PolygonFigure {
    public InsideFigure {
        corners = List.copyOf(corners);
        points = List.copyOf(points);
    }

    /** Sides that pass through many points of a grid, where methods disagree. */
    static InsideFigure firstTriangle() {
        return new InsideFigure(true, CornerList.of(2, 1, 10, 1, 2, 7), CornerList.of(6, 4), false);
    }

    /** Level edges, corners that a ray passes and corners that it touches. */
    static InsideFigure firstPolygon() {
        return new InsideFigure(
                false,
                CornerList.of(0, 0, 9, 0, 11, 4, 9, 8, 6, 8, 6, 4, 4, 6, 2, 4, 0, 8),
                CornerList.of(3, 2.5),
                false);
    }

    public InsideFigure showing(ShapeAndPoints input) {
        return new InsideFigure(
                triangle, CornerList.of(input.corners()), CornerList.of(input.points()), whole);
    }

    public ShapeAndPoints input() {
        return new ShapeAndPoints(CornerList.points(corners), CornerList.points(points));
    }

    public InsideFigure withWhole(boolean only) {
        return new InsideFigure(triangle, corners, points, only);
    }

    /** The points in turn, so that the next one is the first. */
    public InsideFigure next() {
        var turned = new ArrayList<>(points);
        turned.add(turned.remove(0));
        return new InsideFigure(triangle, corners, turned, whole);
    }

    private InsideFigure with(List<PolygonPoint> others) {
        return new InsideFigure(triangle, others, points, whole);
    }

    @Override
    public Map<Grip, PolygonPoint> grips() {
        Map<Grip, PolygonPoint> grips = CornerList.grips(corners);
        grips.put(Grip.POINT, points.get(0));
        return grips;
    }

    @Override
    public InsideFigure moved(Grip grip, PolygonPoint to) {
        PolygonPoint place = whole ? to.whole() : to;
        return grip.kind() == Grip.PolygonGripKind.CORNER
                ? with(CornerList.replaced(corners, grip.index(), place))
                : new InsideFigure(triangle, corners, CornerList.replaced(points, 0, place), whole);
    }

    @Override
    public InsideFigure grown(Grip beside) {
        boolean corner = !triangle && beside.kind() == Grip.PolygonGripKind.CORNER;
        return corner ? with(CornerList.grown(corners, beside.index())) : this;
    }

    @Override
    public InsideFigure without(Grip grip) {
        if (grip.kind() == Grip.PolygonGripKind.CORNER)
            return with(CornerList.removed(corners, grip.index(), 3));
        return points.size() == 1
                ? this
                : new InsideFigure(triangle, corners, points.subList(1, points.size()), whole);
    }

    @Override
    public InsideFigure clicked(PolygonPoint at) {
        PolygonPoint place = whole ? at.whole() : at;
        return triangle ? moved(Grip.POINT, at) : with(CornerList.joined(corners, place));
    }

    @Override
    public double leastStep() {
        return whole ? 1 : 0;
    }
}
