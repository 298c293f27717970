package rasterlab.app.line.figure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.surface.Brush;
import rasterlab.engine.surface.DrawingSurface;
import rasterlab.engine.surface.Pen;

/**
 * A line from point to point and the pen that draws it.
 *
 * @param width in pixels
 * @param round whether ends and joins are round
 */
public record PenFigure(List<RasterPoint> points, double width, boolean round, Dashes dashes)
        implements DrawnFigure {
    /** The picture that the pen draws into, in pixels. */
    static final int WIDTH = 60;

    static final int HEIGHT = 44;
    public static final double NARROWEST = 0.5;
    public static final double WIDEST = 12;
    private static final int MOST = 20;

    public PenFigure {
        points = List.copyOf(points);
    }

    static PenFigure first() {
        return new PenFigure(
                List.of(
                        new RasterPoint(6, 34),
                        new RasterPoint(18, 8),
                        new RasterPoint(30, 34),
                        new RasterPoint(54, 16)),
                5,
                true,
                Dashes.SOLID);
    }

    Pen pen() {
        return new Pen(width, round, dashes.lengths(width));
    }

    /** The picture, in two colours, 0xAARRGGBB. */
    Raster picture(int ground, int ink) {
        var picture = new Raster(WIDTH, HEIGHT);
        picture.clear(ground);
        new DrawingSurface(picture)
                .draw(
                        points.stream().mapToDouble(RasterPoint::x).toArray(),
                        points.stream().mapToDouble(RasterPoint::y).toArray(),
                        pen(),
                        Brush.solid(ink));
        return picture;
    }

    /** How many pixels of the picture the pen lights. */
    public long lit() {
        return Arrays.stream(picture(0, -1).argb()).filter(argb -> argb == -1).count();
    }

    /** The length from point to point, in pixels. */
    public double length() {
        double length = 0;
        for (int i = 1; i < points.size(); i++)
            length +=
                    Math.hypot(
                            points.get(i).x() - points.get(i - 1).x(),
                            points.get(i).y() - points.get(i - 1).y());
        return length;
    }

    public PenFigure withWidth(double other) {
        return new PenFigure(points, other, round, dashes);
    }

    public PenFigure withRound(boolean other) {
        return new PenFigure(points, width, other, dashes);
    }

    public PenFigure withDashes(Dashes other) {
        return new PenFigure(points, width, round, other);
    }

    private PenFigure with(List<RasterPoint> others) {
        return new PenFigure(others, width, round, dashes);
    }

    @Override
    public Map<String, RasterPoint> grips() {
        var grips = new LinkedHashMap<String, RasterPoint>();
        for (int i = 0; i < points.size(); i++) grips.put("point." + i, points.get(i));
        return grips;
    }

    private static int index(String grip) {
        return Integer.parseInt(grip.substring("point.".length()));
    }

    @Override
    public PenFigure moved(String grip, RasterPoint to) {
        var moved = new ArrayList<>(points);
        moved.set(index(grip), clamped(to));
        return with(moved);
    }

    /** The spot, moved to where some pixel is left in the picture if it was too far away. */
    private static RasterPoint clamped(RasterPoint to) {
        return new RasterPoint(
                Math.max(-WIDTH, Math.min(2 * WIDTH, to.x())),
                Math.max(-HEIGHT, Math.min(2 * HEIGHT, to.y())));
    }

    @Override
    public PenFigure added(RasterPoint at) {
        if (points.size() == MOST) return this;
        var more = new ArrayList<>(points);
        more.add(clamped(at));
        return with(more);
    }

    @Override
    public PenFigure without(String grip) {
        if (points.size() == 2) return this;
        var fewer = new ArrayList<>(points);
        fewer.remove(index(grip));
        return with(fewer);
    }
}
