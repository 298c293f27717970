package rasterlab.app.precision;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.ChartSize;
import rasterlab.app.chart.LineNames;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.chart.PowersOfTen;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.row.RowColors;
import rasterlab.engine.visibility.depth.DepthPrecision;
import rasterlab.engine.visibility.depth.DepthPrecision.PrecisionSample;

/**
 * The smallest distance told apart half way to the far plane, over far/near, both logarithmic: a
 * mark where it was measured, a line where a formula predicts it.
 */
public final class DepthPrecisionChart {
    private static final double LEAST_RATIO = 10;
    private static final double MOST_RATIO = 1e9;
    private static final double LOWEST = 1e-10;
    private static final double HIGHEST = 10;

    /** The step of floats changes at powers of two, about three times per decade. */
    private static final int LINE_PER_DECADE = 100;

    private static final int MARKS_PER_DECADE = 2;

    /** The wide line, which shows on both sides of the one that lies on it. */
    private static final String WIDE = "z24";

    /** The line that lies on the wide one, so its marks stand between those. */
    private static final String COVERED = "zfloat";

    private DepthPrecisionChart() {}

    /** A few values to read, a factor of ten apart. */
    public static List<PrecisionSample> table() {
        return DepthPrecision.samples(1);
    }

    public static BufferedImage image(Language language, ChartLook paper) {
        return image(language, paper, ChartSize.USUAL);
    }

    public static BufferedImage image(Language language, ChartLook paper, ChartSize size) {
        return paper.image(size, graphics -> paint(graphics, language, paper, size));
    }

    public static byte[] svg(Language language, ChartLook paper) {
        return paper.svg(graphics -> paint(graphics, language, paper, ChartSize.USUAL));
    }

    private static void paint(
            Graphics2D graphics, Language language, ChartLook paper, ChartSize size) {
        int column = LineNames.width(DepthPrecision.FORMATS, graphics);
        chart(language, paper).paint(graphics, size.width() - column, size.height());
    }

    /** The marks as comma-separated values. */
    public static String csv() {
        return DepthPrecision.samples(MARKS_PER_DECADE).stream()
                .map(
                        sample ->
                                "%s,%s,%s,%s"
                                        .formatted(
                                                sample.format(),
                                                sample.ratio(),
                                                sample.measured(),
                                                sample.predicted()))
                .collect(
                        Collectors.joining(
                                "\r\n", "format,far/near,measured,predicted\r\n", "\r\n"));
    }

    static XYChart chart(Language language, ChartLook paper) {
        Texts texts = Texts.of("precision", language);
        XYChart chart =
                new XYChartBuilder()
                        .title(texts.text("title"))
                        .xAxisTitle(texts.text("ratio"))
                        .yAxisTitle(texts.text("distance"))
                        .build();
        paper.style(chart.getStyler(), texts.locale());
        style(chart.getStyler());
        chart.addAnnotation(new PrecisionNotes(texts, paper, LOWEST, HIGHEST));
        Map<String, MethodLook> looks = MethodLook.of(DepthPrecision.FORMATS, RowColors.OWN);
        List<PrecisionSample> lines = DepthPrecision.samples(LINE_PER_DECADE);
        List<PrecisionSample> marks = DepthPrecision.samples(MARKS_PER_DECADE);
        looks.forEach((format, look) -> line(chart, look.on(paper), of(format, lines)));
        looks.forEach((format, look) -> marks(chart, look.on(paper), of(format, marks)));
        var names = new LineNames(paper.ink());
        looks.forEach((format, look) -> name(names, look.on(paper), of(format, marks)));
        chart.addAnnotation(names);
        return chart;
    }

    private static List<PrecisionSample> of(String format, List<PrecisionSample> samples) {
        return samples.stream().filter(sample -> sample.format().equals(format)).toList();
    }

    private static void line(XYChart chart, MethodLook look, List<PrecisionSample> samples) {
        List<PrecisionSample> inside =
                samples.stream().filter(s -> s.predicted() <= HIGHEST).toList();
        String format = samples.get(0).format();
        XYSeries series =
                chart.addSeries(
                        format + " predicted",
                        inside.stream().mapToDouble(PrecisionSample::ratio).toArray(),
                        inside.stream().mapToDouble(PrecisionSample::predicted).toArray());
        series.setMarker(SeriesMarkers.NONE);
        series.setLineColor(look.color());
        series.setLineStyle(new BasicStroke(format.equals(WIDE) ? 6f : 2f));
    }

    private static void marks(XYChart chart, MethodLook look, List<PrecisionSample> samples) {
        String format = samples.get(0).format();
        int first = format.equals(COVERED) ? 1 : 0;
        List<PrecisionSample> marked =
                IntStream.range(0, samples.size())
                        .filter(i -> i % MARKS_PER_DECADE == first)
                        .mapToObj(samples::get)
                        .toList();
        XYSeries series =
                chart.addSeries(
                        format,
                        marked.stream().mapToDouble(PrecisionSample::ratio).toArray(),
                        marked.stream().mapToDouble(PrecisionSample::measured).toArray());
        series.setMarker(look.marker());
        series.setMarkerColor(look.color());
        series.setLineStyle(SeriesLines.NONE);
    }

    private static void name(LineNames names, MethodLook look, List<PrecisionSample> samples) {
        PrecisionSample last = samples.get(samples.size() - 1);
        names.add(last.format(), last.ratio(), last.predicted(), look.color());
    }

    private static void style(XYStyler styler) {
        styler.setXAxisLogarithmic(true).setXAxisMin(LEAST_RATIO).setXAxisMax(MOST_RATIO);
        styler.setYAxisLogarithmic(true).setYAxisMin(LOWEST).setYAxisMax(HIGHEST);
        styler.setXAxisTickLabelsFormattingFunction(PowersOfTen::nearest);
        styler.setYAxisTickLabelsFormattingFunction(PowersOfTen::nearest);
        styler.setLegendVisible(false);
        styler.setMarkerSize(11);
    }
}
