package rasterlab.app.study;

import de.erichseifert.vectorgraphics2d.Document;
import de.erichseifert.vectorgraphics2d.VectorGraphics2D;
import de.erichseifert.vectorgraphics2d.svg.SVGProcessor;
import de.erichseifert.vectorgraphics2d.util.PageSize;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.knowm.xchart.AnnotationLine;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.canvas.MethodColours;
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
    public static BufferedImage image(Study study) {
        return BitmapEncoder.getBufferedImage(chart(study));
    }

    /** The chart as an SVG document of the same size. */
    static byte[] svg(Study study) {
        var graphics = new VectorGraphics2D();
        chart(study).paint(graphics, WIDTH, HEIGHT);
        Document document =
                new SVGProcessor()
                        .getDocument(graphics.getCommands(), new PageSize(0, 0, WIDTH, HEIGHT));
        var bytes = new ByteArrayOutputStream();
        try {
            document.writeTo(bytes);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    static XYChart chart(Study study) {
        List<String> methods =
                study.measurements().stream().map(Measurement::method).distinct().toList();
        List<Double> errors =
                study.measurements().stream().map(measured -> measured.error().worst()).toList();
        var axis = ErrorAxis.over(errors, methods.size());
        XYChart chart = empty(study);
        style(chart.getStyler(), axis);
        chart.addAnnotation(new AnnotationLine(axis.border(), false, false));
        for (int lane = 0; lane < methods.size(); lane++)
            add(chart, study, methods.get(lane), axis, lane);
        return chart;
    }

    private static XYChart empty(Study study) {
        return new XYChartBuilder()
                .width(WIDTH)
                .height(HEIGHT)
                .title("Speed against accuracy: topic " + study.topic())
                .xAxisTitle("cost: nanoseconds per " + study.item() + " (median)")
                .yAxisTitle("largest error, in " + study.errorUnit())
                .build();
    }

    private static void style(XYStyler styler, ErrorAxis axis) {
        styler.setLegendPosition(LegendPosition.OutsideE);
        styler.setXAxisLogarithmic(true).setXAxisLogarithmicDecadeOnly(false);
        styler.setYAxisLogarithmic(true).setYAxisMin(axis.bottom()).setYAxisMax(axis.top());
        styler.setYAxisTickLabelsFormattingFunction(axis::label);
        styler.setLocale(Locale.ROOT);
        styler.setBaseFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        styler.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 18));
        styler.setChartTitleBoxVisible(false);
        styler.setChartBackgroundColor(Color.WHITE);
        styler.setPlotBackgroundColor(Color.WHITE);
        styler.setAnnotationLineColor(Color.DARK_GRAY);
        styler.setAnnotationLineStroke(new BasicStroke(1.5f));
        styler.setMarkerSize(11);
    }

    private static void add(XYChart chart, Study study, String method, ErrorAxis axis, int lane) {
        List<Measurement> points =
                study.measurements().stream()
                        .filter(measured -> measured.method().equals(method))
                        .filter(StudyChart::hasPoint)
                        .sorted(Comparator.comparingInt(Measurement::size))
                        .toList();
        if (points.isEmpty()) return;
        XYSeries series =
                chart.addSeries(
                        method,
                        points.stream().mapToDouble(p -> p.cost().medianNanos()).toArray(),
                        points.stream()
                                .mapToDouble(p -> axis.position(p.error().worst(), lane))
                                .toArray());
        series.setMarker(MARKERS.get(lane % MARKERS.size()));
        series.setMarkerColor(MethodColours.of(method));
        series.setLineColor(MethodColours.of(method));
        series.setLineStyle(new BasicStroke(2f));
    }

    /** A method that refused, crashed or did not end has no place on the chart. */
    private static boolean hasPoint(Measurement measured) {
        return measured.cost().timed();
    }
}
