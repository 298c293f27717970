package rasterlab.app.study.front;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.LeaderColumn;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.ParetoFront;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.engine.study.measuring.PowerFit;

/**
 * How cost or error grows with size, both axes logarithmic, so that a power is a straight line: its
 * exponent stands behind the method's name with its interval.
 */
public final class SizesChart implements StudyPicture {
    private static final int TOP = 40;

    /** The quantity that grows. */
    public enum Of {
        COST,
        ERROR
    }

    private record Line(String method, List<PowerFit.FittedPoint> points, Optional<PowerFit> fit) {}

    private final Study study;
    private final Of of;
    private final StudyWords words;
    private final ChartLook paper;
    private final String kind;
    private final List<Line> lines = new ArrayList<>();
    private final MethodLines drawing;

    /** The growth over the workloads that differ in nothing but their size. */
    public SizesChart(Study study, Of of, StudyWords words, ChartLook paper) {
        this.study = study;
        this.of = of;
        this.words = words;
        this.paper = paper;
        kind = kindOfMost(study);
        List<String> methods =
                study.measurements().stream().map(Measurement::method).distinct().toList();
        drawing = new MethodLines(MethodLines.looks(study.topic(), methods, paper), paper);
        for (String method : methods) {
            List<PowerFit.FittedPoint> points = points(method);
            if (!points.isEmpty()) lines.add(new Line(method, points, fit(points)));
        }
    }

    private Optional<PowerFit> fit(List<PowerFit.FittedPoint> points) {
        return StudyWords.isSized(study) ? PowerFit.of(points) : Optional.empty();
    }

    /** The kind of workload that has most sizes. */
    static String kindOfMost(Study study) {
        var sizes = new LinkedHashMap<String, Set<Integer>>();
        for (Measurement one : study.measurements())
            sizes.computeIfAbsent(kind(one), key -> new TreeSet<>()).add(one.size());
        return sizes.entrySet().stream()
                .max(Comparator.comparingInt(entry -> entry.getValue().size()))
                .map(Map.Entry::getKey)
                .orElse("");
    }

    /** A workload's name without the word that is its size. */
    static String kind(Measurement point) {
        return point.workload().replaceFirst("-[^-]*", "");
    }

    private List<PowerFit.FittedPoint> points(String method) {
        return study.measurements().stream()
                .filter(one -> one.method().equals(method) && kind(one).equals(kind))
                .filter(one -> one.cost().timed())
                .sorted(Comparator.comparingInt(Measurement::size))
                .map(one -> new PowerFit.FittedPoint(one.size(), value(one)))
                .filter(one -> one.y() > 0 && Double.isFinite(one.y()))
                .toList();
    }

    private double value(Measurement one) {
        return of == Of.COST
                ? one.cost().medianNanos() * itemsPerInput(one)
                : ParetoFront.error(one);
    }

    private static double itemsPerInput(Measurement one) {
        long inputs = one.cost().counts().getOrDefault("inputs", 1L);
        long items = one.cost().counts().getOrDefault("items", 1L);
        return (double) Math.max(1, items) / Math.max(1, inputs);
    }

    /** Each method with its exponent, where there is one. */
    public Map<String, PowerFit> fits() {
        var fits = new LinkedHashMap<String, PowerFit>();
        for (Line line : lines) line.fit().ifPresent(fit -> fits.put(line.method(), fit));
        return fits;
    }

    @Override
    public void paint(Graphics2D graphics, double width, double height) {
        new ChartPage(
                        paper,
                        words.locale(),
                        TOP,
                        words.growthTitle(study, of.name()),
                        lines.stream().map(this::label).toList(),
                        lines.isEmpty()
                                ? words.nothingGrows(study, of.name())
                                        + " "
                                        + words.growthNote(study, of.name())
                                : words.growthNote(study, of.name()))
                .paint(graphics, width, height, (frame, plot) -> paintLines(graphics, frame, plot));
    }

    private void paintLines(Graphics2D graphics, PlotFrame frame, Rectangle2D plot) {
        LogScale across = LogScale.over(values(true), plot.getMinX(), plot.getMaxX());
        LogScale up = LogScale.over(values(false), plot.getMaxY(), plot.getMinY());
        frame.axisRight(
                across, values(true).stream().distinct().sorted().toList(), words.sizeAxis(study));
        frame.axisUp(up, of == Of.COST ? words.costPerInput(study) : words.errorAxis(study));
        var labels = new ArrayList<LeaderColumn.LeaderLabel>();
        for (Line line : lines) {
            List<Point2D> places =
                    line.points().stream()
                            .<Point2D>map(
                                    one -> new Point2D.Double(across.at(one.x()), up.at(one.y())))
                            .toList();
            labels.add(drawing.draw(graphics, line.method(), label(line), places));
            if (of == Of.COST) bars(graphics, line.method(), across, up);
        }
        MethodLines.name(graphics, labels, plot);
    }

    private void bars(Graphics2D graphics, String method, LogScale across, LogScale up) {
        for (Measurement one : study.measurements()) {
            if (!one.method().equals(method) || !kind(one).equals(kind) || !one.cost().timed())
                continue;
            MedianInterval interval = one.cost().interval(study.noise(one.workload()));
            double x = across.at(one.size());
            graphics.draw(
                    new Line2D.Double(
                            x,
                            up.at(interval.low() * itemsPerInput(one)),
                            x,
                            up.at(interval.high() * itemsPerInput(one))));
        }
    }

    private List<Double> values(boolean sizes) {
        return lines.stream()
                .flatMap(line -> line.points().stream())
                .map(point -> sizes ? point.x() : point.y())
                .toList();
    }

    private String label(Line line) {
        String name = words.called(line.method());
        return line.fit()
                .map(fit -> name + "  " + words.power(fit.exponent(), fit.margin()))
                .orElse(name);
    }
}
