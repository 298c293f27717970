package rasterlab.engine.border;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.FillRule;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.CircleTopic;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.circle.EllipseTopic;
import rasterlab.engine.fill.FillTask;
import rasterlab.engine.fill.FillTopic;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.polygon.scan.PolygonFillTopic;
import rasterlab.engine.polygon.scan.PolygonTask;

/** The borders of topics that are drawn in pixels: lines, circles, regions and polygons. */
final class RasterBorders {
    private static final int MOST_STEPS_IN_DOUBLES = 1 << 24;

    /** Curves whose reference is not done in the time of the others. */
    private static final int LARGEST_RADIUS = 300;

    private static final double FARTHEST = 1e100;

    private RasterBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(new LineTopic(), RasterBorders::segment, RasterBorders::tooLong).cut(64),
                Border.of(new CircleTopic(), RasterBorders::circle),
                Border.of(new EllipseTopic(), RasterBorders::ellipse),
                Border.of(new FillTopic(), RasterBorders::region),
                Border.of(new PolygonFillTopic(), RasterBorders::polygon));
    }

    /** Two points anywhere, or close by. */
    private static Segment segment(Draws draws) {
        int x0 = draws.whole(Integer.MIN_VALUE, Integer.MAX_VALUE);
        int y0 = draws.whole(Integer.MIN_VALUE, Integer.MAX_VALUE);
        if (draws.coin()) return new Segment(x0, y0, neighbour(draws, x0), neighbour(draws, y0));
        return new Segment(
                x0,
                y0,
                draws.whole(Integer.MIN_VALUE, Integer.MAX_VALUE),
                draws.whole(Integer.MIN_VALUE, Integer.MAX_VALUE));
    }

    private static int neighbour(Draws draws, int at) {
        long other = (long) at + draws.pick(64) - 32;
        return (int) Math.max(Integer.MIN_VALUE, Math.min(Integer.MAX_VALUE, other));
    }

    private static boolean tooLong(String method, Segment segment, String message) {
        return segment.steps() > MOST_STEPS_IN_DOUBLES
                && !method.equals("bresenham")
                && !method.equals("midpoint");
    }

    private static Circle circle(Draws draws) {
        int radius = draws.whole(0, LARGEST_RADIUS);
        return new Circle(center(draws, radius), center(draws, radius), radius);
    }

    private static Ellipse ellipse(Draws draws) {
        int radiusX = draws.whole(0, LARGEST_RADIUS);
        int radiusY = draws.whole(0, LARGEST_RADIUS);
        return new Ellipse(center(draws, radiusX), center(draws, radiusY), radiusX, radiusY);
    }

    private static int center(Draws draws, int radius) {
        return draws.whole(Integer.MIN_VALUE + radius, Integer.MAX_VALUE - radius);
    }

    private static FillTask region(Draws draws) {
        int width = 1 + draws.pick(7);
        int height = 1 + draws.pick(5);
        var rows = new ArrayList<String>();
        for (int y = 0; y < height; y++) {
            var row = new StringBuilder();
            for (int x = 0; x < width; x++) row.append(".#".charAt(draws.pick(2)));
            rows.add(row.toString());
        }
        int with = ".#o".charAt(draws.pick(3));
        int connectivity = draws.coin() ? 8 : 4;
        return new FillTask(rows, draws.pick(width), draws.pick(height), with, connectivity);
    }

    private static PolygonTask polygon(Draws draws) {
        int corners = draws.pick(7);
        var x = new double[corners];
        var y = new double[corners];
        for (int i = 0; i < corners; i++) {
            x[i] = draws.number(-FARTHEST, FARTHEST);
            y[i] = draws.number(-FARTHEST, FARTHEST);
        }
        FillRule rule = draws.coin() ? FillRule.NON_ZERO : FillRule.EVEN_ODD;
        return new PolygonTask(x, y, rule, 1 + draws.pick(12), 1 + draws.pick(12));
    }
}
