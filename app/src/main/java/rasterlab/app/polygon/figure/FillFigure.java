package rasterlab.app.polygon.figure;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rasterlab.contract.FillRule;
import rasterlab.engine.polygon.scan.PolygonTask;

/**
 * A polygon to be filled, in pixel coordinates.
 *
 * @param width of the picture, in pixels
 * @param height of the picture, in pixels
 */
public record FillFigure(
        List<PolygonPoint> corners, FillRule rule, int width, int height, BrushKind brush)
        implements PolygonFigure {
    public FillFigure {
        corners = List.copyOf(corners);
    }

    /** A star drawn in one stroke, whose middle tells the rules apart. */
    static FillFigure first() {
        var corners = new ArrayList<PolygonPoint>();
        for (int i = 0; i < 5; i++) {
            double angle = 2 * i * 2 * Math.PI / 5;
            corners.add(
                    new PolygonPoint(
                            rounded(21 + 18 * Math.sin(angle)),
                            rounded(19 - 18 * Math.cos(angle))));
        }
        return new FillFigure(corners, FillRule.EVEN_ODD, 43, 36, BrushKind.SOLID);
    }

    private static double rounded(double value) {
        return Math.rint(4 * value) / 4;
    }

    public FillFigure showing(PolygonTask input) {
        var places = new ArrayList<PolygonPoint>();
        for (int i = 0; i < input.x().length; i++)
            places.add(new PolygonPoint(input.x()[i], input.y()[i]));
        return new FillFigure(places, input.rule(), input.width(), input.height(), brush);
    }

    public PolygonTask task() {
        return new PolygonTask(
                corners.stream().mapToDouble(PolygonPoint::x).toArray(),
                corners.stream().mapToDouble(PolygonPoint::y).toArray(),
                rule,
                width,
                height);
    }

    public FillFigure withRule(FillRule other) {
        return new FillFigure(corners, other, width, height, brush);
    }

    public FillFigure withBrush(BrushKind other) {
        return new FillFigure(corners, rule, width, height, other);
    }

    private FillFigure with(List<PolygonPoint> others) {
        return new FillFigure(others, rule, width, height, brush);
    }

    @Override
    public Map<Grip, PolygonPoint> grips() {
        return CornerList.grips(corners);
    }

    @Override
    public FillFigure moved(Grip grip, PolygonPoint to) {
        return with(CornerList.replaced(corners, grip.index(), to));
    }

    @Override
    public FillFigure grown(Grip beside) {
        return with(CornerList.grown(corners, beside.index()));
    }

    @Override
    public FillFigure without(Grip grip) {
        return with(CornerList.removed(corners, grip.index(), 2));
    }

    @Override
    public FillFigure clicked(PolygonPoint at) {
        return with(CornerList.joined(corners, at));
    }

    @Override
    public double leastStep() {
        return 0;
    }
}
