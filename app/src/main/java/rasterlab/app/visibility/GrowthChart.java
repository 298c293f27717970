package rasterlab.app.visibility;

import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleConsumer;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.lines.SeriesLines;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.ChartLook;
import rasterlab.app.study.MethodLook;
import rasterlab.engine.visibility.hidden.Growth;
import rasterlab.engine.visibility.hidden.Growth.Axis;

/** Counted work of the visibility methods over faces and over pixels, all axes logarithmic. */
public final class GrowthChart {
    private static final int TITLE = 40;
    private static final int PANEL_WIDTH = ChartLook.WIDTH / 2;
    private static final int PANEL_HEIGHT = (ChartLook.HEIGHT - TITLE) / 2;
    private static final int ROW = 19;

    /** Pixels of a dash of lines in one place. */
    private static final float DASH = 9;

    private final List<String> methods = Growth.methodNames();
    private final Map<String, MethodLook> looks = MethodLook.of(methods);

    /** What was counted; empty until it is asked for, as that takes some seconds. */
    private List<Growth> growths = List.of();

    /**
     * A chart whose work is counted at once.
     *
     * @param progress gets the share that is done, 0 to 1
     * @throws CancellationException soon after {@code cancelled} says true
     */
    static GrowthChart counted(DoubleConsumer progress, BooleanSupplier cancelled) {
        var chart = new GrowthChart();
        chart.growths = Growth.all(progress, cancelled);
        return chart;
    }

    private List<Growth> growths() {
        if (growths.isEmpty()) growths = Growth.all();
        return growths;
    }

    /** The methods in teaching order. */
    public List<String> methods() {
        return methods;
    }

    /** How a method's work grows along an axis. */
    public Growth growth(String method, Axis axis) {
        return growths().stream()
                .filter(growth -> growth.method().equals(method) && growth.axis() == axis)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no growth of " + method));
    }

    public BufferedImage image(Language language, ChartLook paper) {
        return paper.image(graphics -> paint(graphics, language, paper));
    }

    public byte[] svg(Language language, ChartLook paper) {
        return paper.svg(graphics -> paint(graphics, language, paper));
    }

    /** All points as comma-separated values. */
    public String csv() {
        return growths().stream()
                .flatMap(
                        growth ->
                                IntStream.range(0, growth.sizes().length)
                                        .mapToObj(
                                                i ->
                                                        "%s,%s,%d,%d"
                                                                .formatted(
                                                                        growth.method(),
                                                                        code(growth.axis()),
                                                                        growth.sizes()[i],
                                                                        growth.work()[i])))
                .collect(Collectors.joining("\r\n", "method,axis,size,work\r\n", "\r\n"));
    }

    private static String code(Axis axis) {
        return axis.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private void paint(Graphics2D graphics, Language language, ChartLook paper) {
        Texts texts = Texts.of("visibility", language);
        graphics.setColor(paper.ink());
        graphics.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 18));
        String title = texts.text("growth.title");
        int width = graphics.getFontMetrics().stringWidth(title);
        graphics.drawString(title, (ChartLook.WIDTH - width) / 2, 26);
        Axis[] axes = Axis.values();
        for (int i = 0; i < axes.length; i++) {
            var panel =
                    (Graphics2D)
                            graphics.create(
                                    i % 2 * PANEL_WIDTH,
                                    TITLE + i / 2 * PANEL_HEIGHT,
                                    PANEL_WIDTH,
                                    PANEL_HEIGHT);
            chart(axes[i], texts, paper).paint(panel, PANEL_WIDTH, PANEL_HEIGHT);
            panel.dispose();
        }
        table(graphics, texts, paper);
    }

    private XYChart chart(Axis axis, Texts texts, ChartLook paper) {
        XYChart chart =
                new XYChartBuilder()
                        .title(texts.text("growth." + code(axis)))
                        .xAxisTitle(texts.text("growth." + code(axis) + ".axis"))
                        .yAxisTitle(texts.text("growth.work"))
                        .build();
        paper.style(chart.getStyler());
        style(chart.getStyler());
        for (String method : methods) {
            Growth growth = growth(method, axis);
            XYSeries series =
                    chart.addSeries(
                            method,
                            Arrays.stream(growth.sizes()).asDoubleStream().toArray(),
                            Arrays.stream(growth.work()).asDoubleStream().toArray());
            looks.get(method).on(paper).style(series);
            List<String> together = together(method, axis);
            if (together.size() > 1)
                share(chart, series, together.indexOf(method), together.size());
        }
        return chart;
    }

    /** The methods whose work is the same everywhere along an axis. */
    private List<String> together(String method, Axis axis) {
        long[] work = growth(method, axis).work();
        return methods.stream()
                .filter(other -> Arrays.equals(growth(other, axis).work(), work))
                .toList();
    }

    /**
     * Leaves room for the other lines in the same place: each has every {@code of}-th dash and
     * mark.
     */
    private static void share(XYChart chart, XYSeries series, int turn, int of) {
        float[] dashes = {DASH, DASH * (of - 1)};
        series.setLineStyle(
                new BasicStroke(
                        2,
                        BasicStroke.CAP_BUTT,
                        BasicStroke.JOIN_ROUND,
                        1,
                        dashes,
                        DASH * (of - turn)));
        int[] marked =
                IntStream.range(0, series.getXData().length).filter(i -> i % of == turn).toArray();
        if (marked.length > 0) {
            XYSeries marks =
                    chart.addSeries(
                            series.getName() + " marks",
                            Arrays.stream(marked).mapToDouble(i -> series.getXData()[i]).toArray(),
                            Arrays.stream(marked).mapToDouble(i -> series.getYData()[i]).toArray());
            marks.setMarker(series.getMarker());
            marks.setMarkerColor(series.getMarkerColor());
            marks.setLineStyle(SeriesLines.NONE);
        }
        series.setMarker(SeriesMarkers.NONE);
    }

    private static void style(XYStyler styler) {
        styler.setXAxisLogarithmic(true).setYAxisLogarithmic(true);
        styler.setLegendVisible(false);
        styler.setMarkerSize(5);
        styler.setBaseFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        styler.setChartTitleFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
    }

    /** The exponents, in the corner that the three charts leave. */
    private void table(Graphics2D graphics, Texts texts, ChartLook paper) {
        int left = PANEL_WIDTH + 40;
        int y = TITLE + PANEL_HEIGHT + 22;
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        graphics.setColor(paper.ink());
        graphics.drawString(texts.text("growth.exponents"), left, y);
        y += ROW;
        int column = 0;
        for (Axis axis : Axis.values())
            graphics.drawString(
                    texts.text("growth." + code(axis) + ".short"), left + 150 + 105 * column++, y);
        for (String method : methods) {
            y += ROW;
            MethodLook look = looks.get(method).on(paper);
            graphics.setColor(look.colour());
            var line = (Graphics2D) graphics.create();
            line.setStroke(look.stroke());
            line.drawLine(left - 20, y - 5, left + 12, y - 5);
            line.dispose();
            look.marker().paint(graphics, left - 4, y - 5, 9);
            graphics.setColor(paper.ink());
            graphics.drawString(method, left + 18, y);
            column = 0;
            for (Axis axis : Axis.values())
                graphics.drawString(
                        String.format(texts.locale(), "%.2f", growth(method, axis).exponent())
                                .replace('-', '−'),
                        left + 150 + 105 * column++,
                        y);
        }
    }
}
