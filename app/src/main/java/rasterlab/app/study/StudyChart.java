package rasterlab.app.study;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.apache.batik.dom.GenericDOMImplementation;
import org.apache.batik.svggen.SVGGraphics2D;
import org.apache.batik.svggen.SVGSyntax;
import org.knowm.xchart.AnnotationText;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.canvas.MethodColours;
import rasterlab.app.language.Language;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;

/** A study as a chart: cost to the right, error upwards, one line through each method's sizes. */
public final class StudyChart {
    /** Size of the picture in pixels. */
    private static final int WIDTH = 1000;

    private static final int HEIGHT = 700;

    private static final List<Marker> MARKERS =
            List.of(
                    SeriesMarkers.CIRCLE,
                    SeriesMarkers.SQUARE,
                    SeriesMarkers.TRIANGLE_UP,
                    SeriesMarkers.DIAMOND,
                    SeriesMarkers.TRIANGLE_DOWN,
                    SeriesMarkers.TRAPEZOID);

    private StudyChart() {}

    /** The chart as a picture of 1000 × 700 pixels. */
    public static BufferedImage image(Study study, Language language) {
        return BitmapEncoder.getBufferedImage(chart(study, new StudyWords(language)));
    }

    /** The chart as an SVG document of the same size. */
    static byte[] svg(Study study, Language language) {
        var document =
                GenericDOMImplementation.getDOMImplementation()
                        .createDocument(SVGSyntax.SVG_NAMESPACE_URI, SVGSyntax.SVG_SVG_TAG, null);
        var graphics = new SVGGraphics2D(document);
        graphics.setSVGCanvasSize(new Dimension(WIDTH, HEIGHT));
        chart(study, new StudyWords(language)).paint(graphics, WIDTH, HEIGHT);
        var bytes = new ByteArrayOutputStream();
        try (var writer = new OutputStreamWriter(bytes, StandardCharsets.UTF_8)) {
            graphics.stream(writer, true);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    static XYChart chart(Study study, StudyWords words) {
        var axis = ErrorAxis.over(points(study));
        XYChart chart = empty(study, words);
        style(chart.getStyler(), axis, words);
        chart.addAnnotation(new ErrorGrid(axis));
        List<String> methods = points(study).stream().map(Measurement::method).distinct().toList();
        for (String method : methods) add(chart, method, of(method, points(study)), axis);
        chart.addAnnotation(new LeftOutNote(study, words, WIDTH - 180, HEIGHT - 20));
        return chart;
    }

    private static XYChart empty(Study study, StudyWords words) {
        return new XYChartBuilder()
                .width(WIDTH)
                .height(HEIGHT)
                .title(words.title(study))
                .xAxisTitle(words.costAxis(study))
                .yAxisTitle(words.errorAxis(study))
                .build();
    }

    private static void style(XYStyler styler, ErrorAxis axis, StudyWords words) {
        styler.setLegendPosition(LegendPosition.OutsideE);
        styler.setXAxisLogarithmic(true).setXAxisLogarithmicDecadeOnly(false);
        styler.setYAxisLogarithmic(true)
                .setYAxisLogarithmicDecadeOnly(true)
                .setYAxisMin(axis.bottom())
                .setYAxisMax(axis.top());
        styler.setYAxisTickLabelsFormattingFunction(value -> axis.label(value, words.exact()));
        styler.setLocale(Locale.ROOT);
        styler.setBaseFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        styler.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 18));
        styler.setChartTitleBoxVisible(false);
        styler.setChartBackgroundColor(Color.WHITE);
        styler.setPlotBackgroundColor(Color.WHITE);
        styler.setPlotGridHorizontalLinesVisible(false);
        styler.setAnnotationTextFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        styler.setAnnotationTextFontColor(Color.DARK_GRAY);
        styler.setMarkerSize(11);
    }

    /** A method that refused, crashed or did not end has no cost, hence no place on the chart. */
    private static List<Measurement> points(Study study) {
        return study.measurements().stream().filter(measured -> measured.cost().timed()).toList();
    }

    private static List<Measurement> of(String method, List<Measurement> points) {
        return points.stream()
                .filter(point -> point.method().equals(method))
                .sorted(Comparator.comparingInt(Measurement::size))
                .toList();
    }

    private static void add(
            XYChart chart, String method, List<Measurement> points, ErrorAxis axis) {
        double[] costs = points.stream().mapToDouble(p -> p.cost().medianNanos()).toArray();
        double[] errors = points.stream().mapToDouble(axis::position).toArray();
        Marker marker = MARKERS.get(chart.getSeriesCollection().size() % MARKERS.size());
        XYSeries series = chart.addSeries(method, costs, errors);
        series.setMarker(marker);
        series.setMarkerColor(MethodColours.of(method));
        series.setLineColor(MethodColours.of(method));
        series.setLineStyle(new BasicStroke(2f));
        chart.addAnnotation(sizeLabel(points.get(0), axis));
        if (points.size() > 1) chart.addAnnotation(sizeLabel(points.get(points.size() - 1), axis));
    }

    private static AnnotationText sizeLabel(Measurement point, ErrorAxis axis) {
        return new AnnotationText(
                String.valueOf(point.size()),
                point.cost().medianNanos(),
                axis.above(axis.position(point)),
                false);
    }
}
