package rasterlab.app.polygon.figure;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.engine.fill.FillTask;

/**
 * A picture to be filled from a pixel.
 *
 * @param rows of characters, the top one first, all of one length; {@value #WALL} is a wall
 * @param seed the pixel to fill from; what is wrong with one outside, the methods tell
 * @param pen the pixel where a wall is put up or taken away
 * @param same whether the new colour is the one that the seed has already
 */
public record SeedFigure(
        List<String> rows, PolygonPoint seed, PolygonPoint pen, int connectivity, boolean same)
        implements PolygonFigure {
    public static final char WALL = '#';
    public static final char FREE = '.';
    public static final char NEW = '*';

    public SeedFigure {
        rows = List.copyOf(rows);
        requireAlike(rows);
        int width = rows.get(0).length();
        if (!isPixel(pen, width, rows.size()))
            throw new IllegalArgumentException(
                    "pen must be a pixel of the picture of %d×%d, got (%s, %s)"
                            .formatted(width, rows.size(), pen.x(), pen.y()));
    }

    private static void requireAlike(List<String> rows) {
        if (rows.isEmpty() || rows.get(0).isEmpty())
            throw new IllegalArgumentException("a picture must have at least 1×1 pixel, got none");
        int width = rows.get(0).length();
        for (int y = 0; y < rows.size(); y++)
            if (rows.get(y).length() != width)
                throw new IllegalArgumentException(
                        "row %d must have %d characters as row 0, got %d"
                                .formatted(y, width, rows.get(y).length()));
    }

    /** Two rooms with holes, joined by a diagonal gap. */
    public static SeedFigure first() {
        var rows =
                List.of(
                        "............................",
                        ".############.############..",
                        ".#...........#...........#..",
                        ".#...........#...####....#..",
                        ".#..######...#...#..#....#..",
                        ".#..#....#...#...####....#..",
                        ".#..#....#..#............#..",
                        ".#..######..#.......##...#..",
                        ".#..........#.......##...#..",
                        ".#..........#............#..",
                        ".#...###....#.....#......#..",
                        ".#...#.#....#....#.#.....#..",
                        ".#...###....#.....#......#..",
                        ".#..........#............#..",
                        ".#########################..",
                        "............................");
        return new SeedFigure(rows, new PolygonPoint(3, 3), new PolygonPoint(12, 5), 4, false);
    }

    public SeedFigure showing(FillTask input) {
        boolean inside =
                input.y() >= 0
                        && input.y() < input.rows().size()
                        && input.x() >= 0
                        && input.x() < input.rows().get(input.y()).length();
        boolean old = inside && input.rows().get(input.y()).charAt(input.x()) == input.with();
        return new SeedFigure(
                input.rows(),
                new PolygonPoint(input.x(), input.y()),
                new PolygonPoint(input.rows().get(0).length() - 1.0, input.rows().size() - 1.0),
                input.connectivity(),
                old);
    }

    public FillTask task() {
        int with = same && isInside(seed) ? at(seed) : NEW;
        return new FillTask(rows, (int) seed.x(), (int) seed.y(), with, connectivity);
    }

    public int width() {
        return rows.get(0).length();
    }

    public int height() {
        return rows.size();
    }

    private boolean isInside(PolygonPoint pixel) {
        return isPixel(pixel, width(), height());
    }

    private static boolean isPixel(PolygonPoint place, int width, int height) {
        return place.x() >= 0 && place.x() < width && place.y() >= 0 && place.y() < height;
    }

    private char at(PolygonPoint pixel) {
        return rows.get((int) pixel.y()).charAt((int) pixel.x());
    }

    private PolygonPoint clamped(PolygonPoint place) {
        return new PolygonPoint(
                Math.max(0, Math.min(width() - 1, Math.rint(place.x()))),
                Math.max(0, Math.min(height() - 1, Math.rint(place.y()))));
    }

    public SeedFigure withConnectivity(int other) {
        return new SeedFigure(rows, seed, pen, other, same);
    }

    public SeedFigure withSame(boolean old) {
        return new SeedFigure(rows, seed, pen, connectivity, old);
    }

    private SeedFigure walled(PolygonPoint at, char cell) {
        var changed = new ArrayList<>(rows);
        var row = new StringBuilder(rows.get((int) at.y()));
        row.setCharAt((int) at.x(), cell);
        changed.set((int) at.y(), row.toString());
        return new SeedFigure(changed, seed, at, connectivity, same);
    }

    @Override
    public Map<Grip, PolygonPoint> grips() {
        var grips = new LinkedHashMap<Grip, PolygonPoint>();
        grips.put(Grip.SEED, seed);
        grips.put(Grip.PEN, pen);
        return grips;
    }

    @Override
    public SeedFigure moved(Grip grip, PolygonPoint to) {
        PolygonPoint pixel = clamped(to);
        return grip.kind() == Grip.PolygonGripKind.SEED
                ? new SeedFigure(rows, pixel, pen, connectivity, same)
                : new SeedFigure(rows, seed, pixel, connectivity, same);
    }

    @Override
    public SeedFigure grown(Grip beside) {
        return walled(pen, WALL);
    }

    @Override
    public SeedFigure without(Grip grip) {
        return walled(pen, FREE);
    }

    @Override
    public SeedFigure clicked(PolygonPoint at) {
        if (!isInside(at.whole())) return this;
        return walled(clamped(at), at(clamped(at)) == WALL ? FREE : WALL);
    }

    @Override
    public double leastStep() {
        return 1;
    }
}
