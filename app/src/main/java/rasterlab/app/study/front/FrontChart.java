package rasterlab.app.study.front;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.LeaderColumn;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.Topics;
import rasterlab.engine.study.ExactBound;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.measuring.MedianInterval;

/**
 * Speed against accuracy at one workload: cost to the right, error upwards, the front as a
 * staircase. What counts as exact stands in one row of a band below all errors; what is beaten is
 * pale, and behind its name stands what beats it.
 */
public final class FrontChart implements StudyPicture {
    private static final int TOP = 40;
    private static final int BAND = 56;
    private static final int MARK = 11;
    private static final double PALE = 0.6;
    private static final double LEADER = 0.7;
    private static final int ROW = 26;
    private static final Color EXACT = new Color(0, 158, 115, 32);
    private static final Color NOT_RIGHT = new Color(213, 94, 0, 32);

    private final Study study;
    private final String workload;
    private final StudyWords words;
    private final ChartLook paper;
    private final ParetoFront front;
    private final double bound;
    private final Map<String, MethodLook> looks;
    private final List<PaintedPoint> spots = new ArrayList<>();

    /** Where a point stands, in the chart's units, once it is painted. */
    public record PaintedPoint(Measurement point, double x, double y) {}

    /** The front of the workload that tells most. */
    public FrontChart(Study study, StudyWords words, ChartLook paper) {
        this(study, ParetoFront.telling(study), words, paper);
    }

    /**
     * @param workload its name
     */
    public FrontChart(Study study, String workload, StudyWords words, ChartLook paper) {
        this.study = study;
        this.workload = workload;
        this.words = words;
        this.paper = paper;
        front = ParetoFront.of(study, workload);
        Topic<?, ?, ?> topic = Topics.named(study.topic());
        bound = ExactBound.of(topic);
        List<String> methods = new ArrayList<>(topic.methods().stream().map(Method::name).toList());
        for (Measurement one : study.measurements())
            if (!methods.contains(one.method())) methods.add(one.method());
        looks = MethodLines.looks(study.topic(), methods, paper);
    }

    /** The points, once the chart is painted. */
    public List<PaintedPoint> spots() {
        return List.copyOf(spots);
    }

    @Override
    public void paint(Graphics2D graphics, double width, double height) {
        spots.clear();
        new ChartPage(
                        paper,
                        words.locale(),
                        TOP,
                        words.frontTitle(study, workload),
                        front.ranking().places().stream().map(this::label).toList(),
                        words.frontNote(study, workload))
                .paint(
                        graphics,
                        width,
                        height,
                        (frame, plot) -> paintPoints(graphics, frame, plot));
    }

    private void paintPoints(Graphics2D graphics, PlotFrame frame, Rectangle2D plot) {
        List<Measurement> points = front.ranking().places();
        List<Double> costs = new ArrayList<>();
        for (Measurement point : points) {
            costs.add(interval(point).low());
            costs.add(interval(point).high());
        }
        LogScale across = LogScale.over(costs, plot.getMinX(), plot.getMaxX());
        List<Double> errors =
                points.stream()
                        .map(ParetoFront::error)
                        .filter(error -> error > 0 && Double.isFinite(error))
                        .toList();
        boolean notRight =
                points.stream().anyMatch(point -> Double.isInfinite(ParetoFront.error(point)));
        double top = plot.getMinY() + (notRight ? ROW : 0);
        double border = errors.isEmpty() ? top : plot.getMaxY() - BAND;
        LogScale up = LogScale.over(errors, border - 6, top + 14);
        band(graphics, NOT_RIGHT, plot, plot.getMinY(), top);
        band(graphics, EXACT, plot, border, plot.getMaxY());
        frame.axisRight(across, words.briefCostAxis(study));
        if (errors.isEmpty()) frame.wordsUp(words.errorAxis(study));
        else frame.axisUp(up, words.errorAxis(study));
        double row = (border + plot.getMaxY()) / 2;
        frame.besideLeft(words.exactShort(), row - 7);
        if (bound > 0) frame.besideLeft("≤ " + words.shortNumber(bound), row + 8);
        if (notRight) frame.besideLeft(words.notRightShort(), top - ROW / 2.0);
        for (Measurement point : points) {
            double error = ParetoFront.error(point);
            double y = error == 0 ? row : Double.isFinite(error) ? up.at(error) : top - ROW / 2.0;
            spots.add(new PaintedPoint(point, across.at(point.cost().medianNanos()), y));
        }
        staircase(graphics, plot);
        for (PaintedPoint spot : spots) bars(graphics, spot, across, up, border, errors.isEmpty());
        new LeaderColumn(labels(), plot.getMaxX() + 24, plot.getMinY(), plot.getMaxY())
                .paint(graphics, MARK / 2.0 + 2);
        for (boolean beaten : new boolean[] {true, false})
            for (PaintedPoint spot : spots)
                if (front.isBeaten(spot.point().method()) == beaten)
                    looks.get(spot.point().method())
                            .marker()
                            .paint(ink(graphics, spot.point()), spot.x(), spot.y(), MARK);
    }

    private static void band(
            Graphics2D graphics, Color color, Rectangle2D plot, double top, double bottom) {
        graphics.setColor(color);
        graphics.fill(new Rectangle2D.Double(plot.getMinX(), top, plot.getWidth(), bottom - top));
    }

    private Graphics2D ink(Graphics2D graphics, Measurement point) {
        graphics.setColor(color(point));
        graphics.setStroke(new BasicStroke(1.5f));
        return graphics;
    }

    private MedianInterval interval(Measurement point) {
        return point.cost().interval(study.noise(workload));
    }

    private Color color(Measurement point) {
        Color color = looks.get(point.method()).color();
        return front.isBeaten(point.method())
                ? MethodColors.mix(paper.ground(), color, PALE)
                : color;
    }

    /** Draws the steps from the quickest corner down to the most accurate one and to the right. */
    private void staircase(Graphics2D graphics, Rectangle2D plot) {
        List<PaintedPoint> corners =
                spots.stream().filter(spot -> front.corners().contains(spot.point())).toList();
        if (corners.isEmpty()) return;
        var path = new Path2D.Double();
        path.moveTo(corners.get(0).x(), plot.getMinY());
        double y = corners.get(0).y();
        path.lineTo(corners.get(0).x(), y);
        for (PaintedPoint corner : corners.subList(1, corners.size())) {
            path.lineTo(corner.x(), y);
            y = corner.y();
            path.lineTo(corner.x(), y);
        }
        path.lineTo(plot.getMaxX(), y);
        graphics.setColor(paper.note());
        graphics.setStroke(new BasicStroke(1.6f));
        graphics.draw(path);
    }

    /**
     * Draws the interval of the median, and the errors from the middle input's to the worst one's.
     */
    private void bars(
            Graphics2D graphics,
            PaintedPoint spot,
            LogScale across,
            LogScale up,
            double border,
            boolean allExact) {
        graphics.setColor(color(spot.point()));
        graphics.setStroke(new BasicStroke(1.4f));
        MedianInterval interval = interval(spot.point());
        bar(graphics, across.at(interval.low()), spot.y(), across.at(interval.high()), spot.y());
        List<Double> errors = spot.point().errors().stream().sorted().toList();
        if (allExact || errors.isEmpty() || !Double.isFinite(ParetoFront.error(spot.point())))
            return;
        if (ParetoFront.error(spot.point()) == 0) return;
        double middle = errors.get(errors.size() / 2);
        double y = middle <= Math.max(bound, up.low()) ? border : up.at(middle);
        bar(graphics, spot.x(), spot.y(), spot.x(), y);
    }

    private static void bar(Graphics2D graphics, double x0, double y0, double x1, double y1) {
        graphics.draw(new Line2D.Double(x0, y0, x1, y1));
        double dx = y0 == y1 ? 0 : 3;
        double dy = y0 == y1 ? 3 : 0;
        graphics.draw(new Line2D.Double(x1 - dx, y1 - dy, x1 + dx, y1 + dy));
        if (dx == 0) graphics.draw(new Line2D.Double(x0, y0 - dy, x0, y0 + dy));
    }

    private List<LeaderColumn.LeaderLabel> labels() {
        return spots.stream()
                .map(
                        spot ->
                                new LeaderColumn.LeaderLabel(
                                        label(spot.point()),
                                        spot.x(),
                                        spot.y(),
                                        front.isBeaten(spot.point().method())
                                                ? paper.note()
                                                : paper.ink(),
                                        MethodColors.mix(
                                                paper.ground(), color(spot.point()), LEADER)))
                .toList();
    }

    /** The name, and behind it the quickest method that beats it. */
    private String label(Measurement point) {
        String name = words.called(point.method());
        List<String> by = front.beatenBy().getOrDefault(point.method(), List.of());
        return by.isEmpty() ? name : name + " ← " + words.called(by.get(0));
    }
}
