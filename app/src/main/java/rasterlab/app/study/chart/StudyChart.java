package rasterlab.app.study.chart;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.XYStyler;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.LineNames;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.language.Language;
import rasterlab.app.rooms.LabRooms;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;

/**
 * A study as a chart: cost to the right, error upwards, a line through each method's sizes with its
 * name at the end.
 */
public final class StudyChart {
    private StudyChart() {}

    /** The chart as a picture. */
    public static BufferedImage image(Study study, Language language) {
        var words = new StudyWords(language);
        return ChartLook.PAPER.image(graphics -> paint(study, words, ChartLook.PAPER, graphics));
    }

    /** Draws the chart in the usual size, the methods' names to the right of it. */
    public static void paint(Study study, StudyWords words, ChartLook paper, Graphics2D graphics) {
        var note = LeftOutNote.of(study, words);
        int height = ChartLook.HEIGHT - note.height();
        List<String> names = looks(study, paper).keySet().stream().map(words::called).toList();
        chart(study, words, paper)
                .paint(graphics, ChartLook.WIDTH - LineNames.width(names, graphics), height);
        note.paint(graphics, paper.note(), height);
    }

    static XYChart chart(Study study, StudyWords words, ChartLook paper) {
        var costs = CostAxis.over(points(study));
        var errors = ErrorAxis.over(points(study));
        var sizes = new SizeLabels(paper.ground());
        var names = new LineNames(paper.ink());
        XYChart chart = empty(study, words);
        paper.style(chart.getStyler(), words.locale());
        style(chart.getStyler());
        style(chart.getStyler(), costs, errors, words);
        chart.addAnnotation(new ChartGrid(costs, errors, paper.ink()));
        looks(study, paper)
                .forEach(
                        (method, look) -> {
                            SizeLabels.SizePoint end = end(method, points(study), errors);
                            names.add(
                                    words.called(method), end.cost(), end.position(), look.color());
                            for (List<Measurement> line : lines(method, points(study))) {
                                add(chart, words.called(method), look, line, errors);
                                label(sizes, look, line, errors, point -> words.size(study, point));
                            }
                        });
        sizes.avoidEdge(errors.border());
        sizes.avoidEdge(errors.bottom());
        chart.addAnnotation(sizes);
        chart.addAnnotation(names);
        return chart;
    }

    /** The point of a method that is furthest to the right. */
    private static SizeLabels.SizePoint end(
            String method, List<Measurement> points, ErrorAxis axis) {
        return points.stream()
                .filter(point -> point.method().equals(method))
                .max(Comparator.comparingDouble(StudyChart::cost))
                .map(point -> new SizeLabels.SizePoint(cost(point), axis.position(point)))
                .orElseThrow();
    }

    /** Looks of the methods that have a place on the chart, in teaching order. */
    private static Map<String, MethodLook> looks(Study study, ChartLook paper) {
        List<String> methods =
                study.measurements().stream().map(Measurement::method).distinct().toList();
        var looks =
                new LinkedHashMap<>(MethodLook.of(methods, LabRooms.card(study.topic()).colors()));
        looks.keySet().retainAll(points(study).stream().map(Measurement::method).toList());
        looks.replaceAll((method, look) -> look.on(paper));
        return looks;
    }

    private static XYChart empty(Study study, StudyWords words) {
        return new XYChartBuilder()
                .title(words.title(study))
                .xAxisTitle(words.costAxis(study))
                .yAxisTitle(words.errorAxis(study))
                .build();
    }

    private static void style(XYStyler styler, CostAxis costs, ErrorAxis errors, StudyWords words) {
        styler.setXAxisLogarithmic(true)
                .setXAxisLogarithmicDecadeOnly(false)
                .setXAxisMin(costs.left())
                .setXAxisMax(costs.right());
        styler.setXAxisTickLabelsFormattingFunction(cost -> costs.label(cost, words.locale()));
        styler.setYAxisLogarithmic(true)
                .setYAxisLogarithmicDecadeOnly(false)
                .setYAxisMin(errors.bottom())
                .setYAxisMax(errors.top());
        styler.setYAxisTickLabelsFormattingFunction(error -> errors.label(error, words));
    }

    private static void style(XYStyler styler) {
        styler.setLegendVisible(false);
        styler.setPlotGridLinesVisible(false).setAxisTicksMarksVisible(false);
        styler.setMarkerSize(11);
    }

    /** A method that refused, crashed or did not end has no cost, hence no place on the chart. */
    static List<Measurement> points(Study study) {
        return study.measurements().stream().filter(measured -> measured.cost().timed()).toList();
    }

    /** A method's points, those of one kind of workload together and by size. */
    private static Collection<List<Measurement>> lines(String method, List<Measurement> points) {
        return points.stream()
                .filter(point -> point.method().equals(method))
                .sorted(Comparator.comparingInt(Measurement::size))
                .collect(
                        Collectors.groupingBy(
                                StudyChart::kind, LinkedHashMap::new, Collectors.toList()))
                .values();
    }

    /**
     * A workload's name without its second word, which is its size: only points that differ in
     * nothing else lie on one line.
     */
    private static String kind(Measurement point) {
        return point.workload().replaceFirst("-[^-]*", "");
    }

    private static void add(
            XYChart chart,
            String method,
            MethodLook look,
            List<Measurement> points,
            ErrorAxis axis) {
        double[] costs = points.stream().mapToDouble(StudyChart::cost).toArray();
        double[] errors = points.stream().mapToDouble(axis::position).toArray();
        boolean first =
                chart.getSeriesCollection().stream().noneMatch(s -> s.getName().equals(method));
        String name = first ? method : method + " " + kind(points.get(0));
        XYSeries series = chart.addSeries(name, costs, errors);
        series.setShowInLegend(first);
        look.style(series);
    }

    /** Writes the least and the greatest size. */
    private static void label(
            SizeLabels sizes,
            MethodLook look,
            List<Measurement> points,
            ErrorAxis axis,
            Function<Measurement, String> said) {
        List<SizeLabels.SizePoint> line =
                points.stream()
                        .map(point -> new SizeLabels.SizePoint(cost(point), axis.position(point)))
                        .toList();
        sizes.avoid(line);
        sizes.add(said.apply(points.get(0)), line.get(0), look.color());
        int last = points.size() - 1;
        if (last > 0) sizes.add(said.apply(points.get(last)), line.get(last), look.color());
    }

    private static double cost(Measurement point) {
        return point.cost().medianNanos();
    }
}
