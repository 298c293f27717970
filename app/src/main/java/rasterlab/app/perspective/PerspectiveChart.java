package rasterlab.app.perspective;

import java.awt.BasicStroke;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Collectors;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.transform.PerspectiveAmount;
import rasterlab.engine.transform.PerspectiveAmount.PerspectiveSample;

/** γ = 1 + 2·dz'/z' over z'/dz', from a quarter of the depth to twelve of them. */
public final class PerspectiveChart {
    private static final double NEAREST = 0.25;
    private static final double FARTHEST = 12;
    private static final double HIGHEST = 9;

    private PerspectiveChart() {}

    /** A few values to read, half a depth apart. */
    public static List<PerspectiveSample> table() {
        return PerspectiveAmount.chart(0.5, FARTHEST, 24);
    }

    /** The points of the curve, a sixteenth of a depth apart. */
    private static List<PerspectiveSample> curve() {
        return PerspectiveAmount.chart(NEAREST, FARTHEST, 189);
    }

    public static BufferedImage image(Language language) {
        return ChartLook.PAPER.image(
                graphics -> chart(language).paint(graphics, ChartLook.WIDTH, ChartLook.HEIGHT));
    }

    public static byte[] svg(Language language) {
        return ChartLook.PAPER.svg(
                graphics -> chart(language).paint(graphics, ChartLook.WIDTH, ChartLook.HEIGHT));
    }

    /** The points of the curve as comma-separated values. */
    public static String csv() {
        return curve().stream()
                .map(
                        sample ->
                                "%s,%s,%s"
                                        .formatted(
                                                sample.distance(),
                                                sample.gamma(),
                                                Stretch.of(sample.distance()).code()))
                .collect(Collectors.joining("\r\n", "distance,gamma,stretch\r\n", "\r\n"));
    }

    static XYChart chart(Language language) {
        Texts texts = Texts.of("perspective", language);
        XYChart chart =
                new XYChartBuilder()
                        .title(texts.text("title"))
                        .xAxisTitle(texts.text("distance"))
                        .yAxisTitle(texts.text("gamma"))
                        .build();
        ChartLook.PAPER.style(chart.getStyler(), texts.locale());
        style(chart.getStyler());
        chart.addAnnotation(new StretchBands(texts, HIGHEST));
        XYSeries series =
                chart.addSeries(
                        "gamma",
                        curve().stream().mapToDouble(PerspectiveSample::distance).toArray(),
                        curve().stream().mapToDouble(PerspectiveSample::gamma).toArray());
        series.setMarker(SeriesMarkers.NONE);
        series.setLineColor(MethodColors.BLUE);
        series.setLineStyle(new BasicStroke(3f));
        return chart;
    }

    private static void style(XYStyler styler) {
        styler.setXAxisMin(0.0).setXAxisMax(FARTHEST).setYAxisMin(0.0).setYAxisMax(HIGHEST);
        styler.setLegendVisible(false);
        styler.setXAxisDecimalPattern("#.#").setYAxisDecimalPattern("#.#");
    }
}
