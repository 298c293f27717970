package rasterlab.app.polygon;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.List;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PathLines;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.polygon.figure.CornerList;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.outcome.InsideAnswer;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.engine.polygon.ExactMembership;
import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.raster.PixelMark;

/**
 * Shows what a method says of every point in sight, beside the exact answer or a second method.
 *
 * @param other the second method, "" for the exact answer
 * @param step as {@link PolygonLabState#step}
 * @param taken places of handles and labels, where no words stand if there is room elsewhere
 */
record InsidePicture(
        PolygonTopics topics,
        PolygonMode mode,
        InsideFigure figure,
        String method,
        InsideAnswer answer,
        String other,
        int step,
        Texts texts,
        List<Rectangle> taken)
        implements PlanePicture {
    /** View units between points that a program of the user's is asked for, at least. */
    private static final double OWN_APART = 12;

    private static final double MARK = 18;

    /** View units across the ring round a step's point. */
    private static final double RING = 30;

    @Override
    public PlanePicture leaving(List<Rectangle> labels) {
        return new InsidePicture(topics, mode, figure, method, answer, other, step, texts, labels);
    }

    @Override
    public List<Line2D> lines(PlaneMap map, Rectangle view) {
        return PathLines.of(FigureLines.ring(figure.corners(), map), view);
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        var strokes = new FigureLines(g, map, colors);
        ClassificationField judged = field(g, map, cancelled);
        var field = new FieldPainter(g, map, colors, judged);
        Color first = PolygonColors.OWN.of(method);
        field.paintInside(first);
        strokes.outline(figure.corners(), colors.ink(), 1.6f);
        boolean exact = other.isEmpty();
        field.paintDifferences(
                exact ? MethodColors.VERMILLION : first,
                exact ? MethodColors.VERMILLION : PolygonColors.OWN.of(other));
        paintPoints(g, map, colors);
        if (step > 0 && step <= answer.steps()) paintStep(g, map, strokes, colors);
        count(g, judged, colors);
    }

    /** Writes how many of the points in sight are wrong, in a corner without buttons. */
    private void count(Graphics2D g, ClassificationField field, StageColors colors) {
        String said =
                texts.text(
                        other.isEmpty() ? "field.wrong" : "field.differ",
                        field.differing(),
                        field.judged());
        FontMetrics metrics = g.getFontMetrics();
        var words = CornerWords.of(said, g.getClipBounds(), metrics, taken);
        int base = words.place().y + metrics.getAscent();
        for (String line : words.lines()) {
            Color plate = Plates.nearlyOpaque(colors.ground());
            Plates.plate(g, line, words.place().x, base, plate, colors.ink());
            base += metrics.getHeight();
        }
    }

    private ClassificationField field(Graphics2D g, PlaneMap map, BooleanSupplier cancelled) {
        Points corners = CornerList.points(figure.corners());
        Membership.PointClassifier second =
                other.isEmpty() ? new ExactMembership(corners) : topics.judge(mode, other, corners);
        boolean whole = figure.whole() || takesWholeOnly(method) || takesWholeOnly(other);
        return ClassificationField.of(
                map,
                g.getClipBounds(),
                Math.max(whole ? 1 : 0, leastStep(map)),
                topics.judge(mode, method, corners),
                second,
                cancelled);
    }

    /** A program of the user's is asked for fewer points: each takes the way to its process. */
    private double leastStep(PlaneMap map) {
        boolean own = method.equals(OwnMethods.NAME) || other.equals(OwnMethods.NAME);
        return own ? Math.scalb(1.0, Math.getExponent(map.worldWidth(OWN_APART)) + 1) : 0;
    }

    private static boolean takesWholeOnly(String method) {
        return method.equals("sign-int");
    }

    private void paintPoints(Graphics2D g, PlaneMap map, StageColors colors) {
        List<PolygonPoint> points = figure.points();
        for (int i = 0; i < points.size(); i++) {
            double x = map.viewX(points.get(i).x());
            double y = map.viewY(points.get(i).y());
            if (!g.getClipBounds().contains(x, y)) continue;
            g.setColor(colors.ink());
            if (i > 0) g.fill(new Ellipse2D.Double(x - 2.5, y - 2.5, 5, 5));
            if (!answer.isWrong(i) || !isTold(i)) continue;
            PixelMark mark = answer.inside().get(i) ? PixelMark.EXTRA : PixelMark.MISSING;
            mark.paint(g, x - MARK / 2, y - MARK / 2, MARK);
        }
    }

    /** Whether the method's answer to a point was among the steps so far, if they are answers. */
    private boolean isTold(int point) {
        return !answer.pointwise() || point < step;
    }

    private void paintStep(Graphics2D g, PlaneMap map, FigureLines strokes, StageColors colors) {
        if (answer.pointwise()) paintAnswer(g, map, strokes, colors);
        else paintSide(strokes, colors);
    }

    /** Draws a ring round the point that the step is about, with what is said of it. */
    private void paintAnswer(Graphics2D g, PlaneMap map, FigureLines strokes, StageColors colors) {
        PolygonPoint point = figure.points().get(step - 1);
        double x = map.viewX(point.x());
        double y = map.viewY(point.y());
        if (!g.getClipBounds().contains(x, y)) return;
        g.setColor(colors.focus());
        g.setStroke(new BasicStroke(3));
        g.draw(new Ellipse2D.Double(x - RING / 2, y - RING / 2, RING, RING));
        String said = texts.text(answer.inside().get(step - 1) ? "inside" : "outside");
        strokes.words(said, point, 0, (int) RING);
    }

    private void paintSide(FigureLines strokes, StageColors colors) {
        InsideAnswer.AskedSide side = answer.sides().get(step - 1);
        PolygonPoint point = figure.points().get(0);
        PolygonPoint from = figure.corners().get(side.from());
        PolygonPoint to = figure.corners().get(side.to());
        if (mode == PolygonMode.POLYGON)
            strokes.dashed(point, new PolygonPoint(reach(point), point.y()), colors.focus());
        if (side.from() == side.to()) strokes.dashed(point, from, colors.focus());
        else strokes.line(from, to, colors.focus(), 4);
        var middle = new PolygonPoint((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
        strokes.words(PolygonReadings.value(side.value(), texts.locale()), middle, 0, 0);
    }

    /** Where the ray to the right is beyond all corners. */
    private double reach(PolygonPoint point) {
        double most = point.x();
        for (PolygonPoint corner : figure.corners()) most = Math.max(most, corner.x());
        return most + (most - point.x()) / 4;
    }
}
