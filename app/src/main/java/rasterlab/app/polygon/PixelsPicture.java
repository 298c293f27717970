package rasterlab.app.polygon;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PathLines;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.polygon.figure.BrushKind;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.app.polygon.outcome.PixelAnswer;
import rasterlab.app.polygon.outcome.Runs;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.surface.Brush;

/**
 * Pixels that a method has filled, on what was there before.
 *
 * @param wrong what is marked when the result is shown
 * @param step as {@link PolygonLabState#step}
 */
record PixelsPicture(
        PolygonFigure figure, String method, PixelAnswer answer, WrongPixels wrong, int step)
        implements PlanePicture {
    /** The view units a pixel from which on lines between pixels and marks are drawn. */
    private static final double GRID = 5;

    private static final double LARGEST_MARK = 44;

    /**
     * Pixels that are marked as wrong, or as filled by one of two methods only.
     *
     * @param second the other method, whose pixels the missing ones are; "" for the exact answer
     */
    record WrongPixels(PixelSet missing, PixelSet extra, String second) {}

    @Override
    public List<Line2D> lines(PlaneMap map, Rectangle view) {
        return figure instanceof FillFigure fill
                ? PathLines.of(FigureLines.ring(fill.corners(), map), view)
                : List.of();
    }

    /** Runs that are filled so far, missing pixels, and what was there before. */
    @Override
    public List<Rectangle2D> pixels(PlaneMap map, Rectangle view) {
        var pixels = new ArrayList<Rectangle2D>();
        for (int run = 0; run < Math.min(step, answer.steps()); run++) pixels.add(frame(map, run));
        if (step > answer.steps())
            each(wrong.missing(), (x, y) -> pixels.add(frame(map, x, x + 1, y)));
        if (figure instanceof SeedFigure seed)
            for (int y = 0; y < seed.height(); y++)
                for (int x = 0; x < seed.width(); x++)
                    if (seed.rows().get(y).charAt(x) != SeedFigure.FREE)
                        pixels.add(frame(map, x, x + 1, y));
        pixels.removeIf(pixel -> !view.intersects(pixel));
        return pixels;
    }

    @Override
    public double leastTick() {
        return figure instanceof SeedFigure ? 1 : 0;
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        BufferedImage image = image(colors);
        var frame =
                new Rectangle2D.Double(
                        map.viewX(-0.5),
                        map.viewY(-0.5),
                        image.getWidth() * map.scaleX(),
                        image.getHeight() * map.scaleY());
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        Rectangle whole = frame.getBounds();
        if (frame.width <= 4e4 && frame.height <= 4e4)
            g.drawImage(
                    image,
                    (int) Math.round(frame.x),
                    (int) Math.round(frame.y),
                    (int) Math.round(frame.width),
                    (int) Math.round(frame.height),
                    null);
        if (map.scaleX() >= GRID) {
            grid(g, map, colors, image);
            edges(g, map, colors);
        }
        g.setColor(colors.axis());
        g.drawRect(whole.x, whole.y, whole.width, whole.height);
        var strokes = new FigureLines(g, map, colors);
        if (figure instanceof FillFigure fill) {
            strokes.outline(fill.corners(), colors.ground(), 4);
            strokes.outline(fill.corners(), colors.ink(), 1.8f);
        }
        if (step > 0 && step <= answer.steps()) paintStep(g, map, strokes, colors, image);
        if (step > answer.steps()) paintWrong(g, map);
    }

    /** One pixel each; what is filled so far in the method's colour, by the figure's brush. */
    private BufferedImage image(StageColors colors) {
        boolean fill = figure instanceof FillFigure;
        int width = fill ? ((FillFigure) figure).width() : ((SeedFigure) figure).width();
        int height = fill ? ((FillFigure) figure).height() : ((SeedFigure) figure).height();
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) image.setRGB(x, y, before(x, y, colors).getRGB());
        Color color = PolygonColors.OWN.of(method);
        BrushKind kind = fill ? ((FillFigure) figure).brush() : BrushKind.SOLID;
        Brush brush =
                kind.brush(color.getRGB())
                        .over(Brush.solid(MethodColors.mix(colors.ground(), color, 0.12).getRGB()));
        int runs = Math.min(step, answer.steps());
        for (int run = 0; run < runs; run++)
            for (int x = answer.runs().from(run); x < answer.runs().to(run); x++)
                image.setRGB(x, answer.runs().y(run), brush.color(x, answer.runs().y(run)));
        return image;
    }

    private Color before(int x, int y, StageColors colors) {
        if (!(figure instanceof SeedFigure seed)) return colors.ground();
        char cell = seed.rows().get(y).charAt(x);
        if (cell == SeedFigure.FREE) return colors.ground();
        double share = cell == SeedFigure.WALL ? 0.75 : 0.3;
        return MethodColors.mix(colors.ground(), colors.ink(), share);
    }

    private static void grid(Graphics2D g, PlaneMap map, StageColors colors, BufferedImage image) {
        Color line = colors.grid();
        g.setColor(new Color(line.getRed(), line.getGreen(), line.getBlue(), 150));
        double left = map.viewX(-0.5);
        double top = map.viewY(-0.5);
        double right = map.viewX(image.getWidth() - 0.5);
        double bottom = map.viewY(image.getHeight() - 0.5);
        for (int x = 1; x < image.getWidth(); x++)
            g.draw(new Line2D.Double(map.viewX(x - 0.5), top, map.viewX(x - 0.5), bottom));
        for (int y = 1; y < image.getHeight(); y++)
            g.draw(new Line2D.Double(left, map.viewY(y - 0.5), right, map.viewY(y - 0.5)));
    }

    /** Draws an edge around each run, so that every colour is seen on the ground. */
    private void edges(Graphics2D g, PlaneMap map, StageColors colors) {
        g.setColor(MethodColors.edgeOn(colors.ground(), PolygonColors.OWN.of(method)));
        g.setStroke(new BasicStroke(1));
        for (int run = 0; run < Math.min(step, answer.steps()); run++) g.draw(frame(map, run));
    }

    private Rectangle2D frame(PlaneMap map, int run) {
        Runs runs = answer.runs();
        return frame(map, runs.from(run), runs.to(run), runs.y(run));
    }

    private static Rectangle2D frame(PlaneMap map, int from, int to, int y) {
        return new Rectangle2D.Double(
                map.viewX(from - 0.5),
                map.viewY(y - 0.5),
                (to - from) * map.scaleX(),
                map.scaleY());
    }

    private void paintStep(
            Graphics2D g,
            PlaneMap map,
            FigureLines strokes,
            StageColors colors,
            BufferedImage image) {
        int run = step - 1;
        int y = answer.runs().y(run);
        if (figure instanceof FillFigure)
            strokes.dashed(
                    new PolygonPoint(-0.5, y),
                    new PolygonPoint(image.getWidth() - 0.5, y),
                    colors.focus());
        g.setColor(colors.focus());
        g.setStroke(new BasicStroke(2.5f));
        g.draw(frame(map, run));
        answer.crossings()
                .getOrDefault(y, List.of())
                .forEach(
                        crossing ->
                                strokes.words(
                                        crossing.winding() > 0 ? "+1" : "−1",
                                        new PolygonPoint(crossing.x(), y),
                                        0,
                                        -map.scaleY() - 6));
    }

    private void paintWrong(Graphics2D g, PlaneMap map) {
        boolean exact = wrong.second().isEmpty();
        each(wrong.missing(), (x, y) -> mark(g, map, x, y, PixelMark.MISSING, exact));
        each(wrong.extra(), (x, y) -> mark(g, map, x, y, PixelMark.EXTRA, exact));
    }

    private interface Pixel {
        void at(int x, int y);
    }

    private static void each(PixelSet set, Pixel action) {
        for (int i = 0; i < set.size(); i++) action.at(set.x(i), set.y(i));
    }

    private void mark(Graphics2D g, PlaneMap map, int x, int y, PixelMark mark, boolean exact) {
        double size = map.scaleX();
        double left = map.viewX(x - 0.5);
        double top = map.viewY(y - 0.5);
        if (!g.getClipBounds().intersects(left, top, size, size)) return;
        if (!exact || size < GRID) {
            String owner = mark == PixelMark.EXTRA ? method : wrong.second();
            g.setColor(exact ? MethodColors.VERMILLION : PolygonColors.OWN.of(owner));
            g.fill(new Rectangle2D.Double(left, top, size, size));
        }
        double shown = Math.min(size, LARGEST_MARK);
        double inset = (size - shown) / 2;
        if (size >= GRID) mark.paint(g, left + inset, top + inset, shown);
    }
}
