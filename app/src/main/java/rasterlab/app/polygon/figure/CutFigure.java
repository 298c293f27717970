package rasterlab.app.polygon.figure;

import java.util.List;
import java.util.Map;

/** A polygon to be cut into triangles. */
public record CutFigure(List<PolygonPoint> corners) implements PolygonFigure {
    public CutFigure {
        corners = List.copyOf(corners);
    }

    /** A fish: corners that turn inward, and ears that others lie in. */
    static CutFigure first() {
        return new CutFigure(
                CornerList.of(
                        0, 4, 3, 1.2, 7, 0.4, 10, 2, 13, 0, 12.2, 4, 13.4, 7.6, 10, 5.8, 8, 8.8,
                        6.6, 6.8, 3, 6.6));
    }

    @Override
    public Map<Grip, PolygonPoint> grips() {
        return CornerList.grips(corners);
    }

    @Override
    public CutFigure moved(Grip grip, PolygonPoint to) {
        return new CutFigure(CornerList.replaced(corners, grip.index(), to));
    }

    @Override
    public CutFigure grown(Grip beside) {
        return new CutFigure(CornerList.grown(corners, beside.index()));
    }

    @Override
    public CutFigure without(Grip grip) {
        return new CutFigure(CornerList.removed(corners, grip.index(), 3));
    }

    @Override
    public CutFigure clicked(PolygonPoint at) {
        return new CutFigure(CornerList.joined(corners, at));
    }

    @Override
    public double leastStep() {
        return 0;
    }
}
