package rasterlab.app.polygon;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.app.canvas.PathLines;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.outcome.CutAnswer;
import rasterlab.app.polygon.outcome.CutAnswer.CutTriangle;
import rasterlab.app.polygon.outcome.CutAnswer.TriangleFault;
import rasterlab.engine.raster.PixelMark;

/**
 * A polygon and the triangles that a method has cut off it.
 *
 * @param other cuts of a second method whose diagonals are compared; none where it has a picture of
 *     its own
 * @param otherMethod its name, "" for none
 * @param step as {@link PolygonLabState#step}
 * @param taken places of handles and labels, where no number stands if there is room elsewhere
 */
record CutPicture(
        CutFigure figure,
        String method,
        CutAnswer answer,
        List<CutTriangle> other,
        String otherMethod,
        int step,
        List<Rectangle> taken)
        implements PlanePicture {
    private static final double MARK = 20;

    /** Where numbers may stand on the way from the middle of a triangle to a corner or a side. */
    private static final double[] PARTS = {0.25, 0.4, 0.55, 0.7};

    @Override
    public PlanePicture leaving(List<Rectangle> labels) {
        return new CutPicture(figure, method, answer, other, otherMethod, step, labels);
    }

    @Override
    public List<Line2D> lines(PlaneMap map, Rectangle view) {
        return PathLines.of(FigureLines.ring(figure.corners(), map), view);
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        var strokes = new FigureLines(g, map, colors);
        List<CutTriangle> made = answer.cuts().subList(0, Math.min(step, answer.steps()));
        strokes.area(figure.corners(), colors.axis(), 40);
        Color color = PolygonColors.OWN.of(method);
        boolean stepping = step > 0 && step <= answer.steps();
        for (int i = 0; i < made.size(); i++) {
            boolean now = stepping && i == made.size() - 1;
            strokes.area(corners(made.get(i)), now ? colors.focus() : color, now ? 110 : 70);
        }
        for (CutTriangle cut : made) strokes.outline(corners(cut), edge(colors, color), 1.8f);
        for (CutTriangle cut : other)
            strokes.dashed(
                    figure.corners().get(cut.a()),
                    figure.corners().get(cut.c()),
                    edge(colors, PolygonColors.OWN.of(otherMethod)));
        strokes.outline(figure.corners(), colors.ink(), 2);
        if (stepping) paintStep(strokes, made.get(made.size() - 1), colors);
        for (CutTriangle cut : made) if (cut.fault() != TriangleFault.NONE) mark(g, map, cut);
        if (made.size() <= 30) number(strokes, made);
    }

    private static Color edge(StageColors colors, Color color) {
        return MethodColors.edgeOn(colors.ground(), color);
    }

    private List<PolygonPoint> corners(CutTriangle cut) {
        List<PolygonPoint> corners = figure.corners();
        return List.of(corners.get(cut.a()), corners.get(cut.b()), corners.get(cut.c()));
    }

    private void paintStep(FigureLines strokes, CutTriangle cut, StageColors colors) {
        List<PolygonPoint> corners = corners(cut);
        strokes.line(corners.get(0), corners.get(2), colors.focus(), 4);
    }

    /** Marks the middle of the triangle, shared with its number: the number stands above. */
    private void mark(Graphics2D g, PlaneMap map, CutTriangle cut) {
        PolygonPoint middle = middle(cut);
        PixelMark.EXTRA.paint(
                g, map.viewX(middle.x()) - MARK / 2, map.viewY(middle.y()) - MARK / 2, MARK);
    }

    /**
     * Writes each in its triangle, and clear of labels and of the numbers before it where it can
     * be.
     */
    private void number(FigureLines strokes, List<CutTriangle> made) {
        var full = new ArrayList<Rectangle>(taken);
        for (int i = 0; i < made.size(); i++) {
            CutTriangle cut = made.get(i);
            String number = String.valueOf(i + 1);
            double down = cut.fault() == TriangleFault.NONE ? 0 : MARK;
            PolygonPoint at =
                    places(cut)
                            .filter(
                                    place ->
                                            full.stream()
                                                    .noneMatch(
                                                            strokes.plate(number, place, 0, down)
                                                                    ::intersects))
                            .findFirst()
                            .orElse(middle(cut));
            full.add(strokes.plate(number, at, 0, down));
            strokes.words(number, at, 0, down);
        }
    }

    /**
     * The places in the triangle: its middle first, then towards its sides, then towards its
     * corners.
     */
    private Stream<PolygonPoint> places(CutTriangle cut) {
        List<PolygonPoint> corners = corners(cut);
        PolygonPoint middle = middle(cut);
        Stream<PolygonPoint> sides =
                IntStream.range(0, 3)
                        .mapToObj(i -> between(corners.get(i), corners.get((i + 1) % 3), 0.5));
        List<PolygonPoint> ends = Stream.concat(sides, corners.stream()).toList();
        return Stream.concat(
                Stream.of(middle),
                DoubleStream.of(PARTS)
                        .boxed()
                        .flatMap(part -> ends.stream().map(end -> between(middle, end, part))));
    }

    private static PolygonPoint between(PolygonPoint from, PolygonPoint to, double part) {
        return new PolygonPoint(
                from.x() + part * (to.x() - from.x()), from.y() + part * (to.y() - from.y()));
    }

    private PolygonPoint middle(CutTriangle cut) {
        List<PolygonPoint> corners = corners(cut);
        return between(corners.get(0), between(corners.get(1), corners.get(2), 0.5), 2 / 3.0);
    }
}
