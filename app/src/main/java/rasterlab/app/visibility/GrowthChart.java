package rasterlab.app.visibility;

import java.awt.BasicStroke;
import java.awt.Dimension;
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
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.ChartSize;
import rasterlab.app.chart.LineNames;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.chart.PowersOfTen;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.visibility.hidden.Growth;
import rasterlab.engine.visibility.hidden.Growth.Axis;

/** Counted work of the visibility methods over faces and over pixels, all axes logarithmic. */
public final class GrowthChart {
    /** Height of the title above the charts. */
    static final int TITLE = 40;

    /**
     * The least width for the charts and the table, in units of which the chart's type is 14 high.
     */
    private static final int LEAST_WIDTH = 900;

    private static final int LEAST_HEIGHT = 580;

    /** Pixels of a dash of lines in one place. */
    private static final float DASH = 9;

    private final List<String> methods = Growth.methodNames();
    private final Map<String, MethodLook> looks = MethodLook.of(methods, VisibilityColors.OWN);

    /** The counts; empty until they are asked for, as that takes some seconds. */
    private List<Growth> growths;

    public GrowthChart() {
        this(List.of());
    }

    /**
     * @param growths of all methods on all axes, none for those that are counted when asked for
     */
    GrowthChart(List<Growth> growths) {
        this.growths = growths;
    }

    /**
     * A chart whose work is counted at once.
     *
     * @param progress gets the share that is done, 0 to 1
     * @throws CancellationException soon after {@code cancelled} says true
     */
    static GrowthChart counted(DoubleConsumer progress, BooleanSupplier cancelled) {
        return new GrowthChart(Growth.all(progress, cancelled));
    }

    private List<Growth> growths() {
        if (growths.isEmpty()) growths = Growth.all();
        return growths;
    }

    /** A size as {@link ChartSize#filling} gives it, for this chart. */
    static ChartSize filling(int width, int height, double wanted) {
        return ChartSize.filling(width, height, wanted, LEAST_WIDTH, LEAST_HEIGHT);
    }

    /** The methods in teaching order. */
    public List<String> methods() {
        return methods;
    }

    /** How a method's line and marks look on white paper. */
    MethodLook look(String method) {
        return looks.get(method);
    }

    /** How a method's work grows along an axis. */
    public Growth growth(String method, Axis axis) {
        return growths().stream()
                .filter(growth -> growth.method().equals(method) && growth.axis() == axis)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no growth of " + method));
    }

    public BufferedImage image(Language language, ChartLook paper) {
        return image(language, paper, ChartSize.USUAL);
    }

    BufferedImage image(Language language, ChartLook paper, ChartSize size) {
        return paper.image(size, graphics -> paint(graphics, language, paper, size));
    }

    public byte[] svg(Language language, ChartLook paper) {
        return paper.svg(graphics -> paint(graphics, language, paper, ChartSize.USUAL));
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

    static String code(Axis axis) {
        return axis.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private void paint(Graphics2D graphics, Language language, ChartLook paper, ChartSize size) {
        Texts texts = Texts.of("visibility", language);
        graphics.setColor(paper.ink());
        title(graphics, texts.text("growth.title"), size.width());
        var panel = new Dimension(size.width() / 2, (size.height() - TITLE) / 2);
        Axis[] axes = Axis.values();
        for (int i = 0; i < axes.length; i++) {
            var part = part(graphics, i % 2, i / 2, panel);
            int column = LineNames.width(methods, part);
            chart(axes[i], texts, paper).paint(part, panel.width - column, panel.height);
            part.dispose();
        }
        var rest = part(graphics, 1, 1, panel);
        new GrowthTable(this, texts, paper).paint(rest, panel);
        rest.dispose();
    }

    /** One of four parts of equal size below the title. */
    private static Graphics2D part(Graphics2D graphics, int column, int row, Dimension panel) {
        return (Graphics2D)
                graphics.create(
                        column * panel.width,
                        TITLE + row * panel.height,
                        panel.width,
                        panel.height);
    }

    /** Writes the title in the middle, in smaller type where it is too long. */
    private static void title(Graphics2D graphics, String title, int width) {
        graphics.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 18));
        double wide = graphics.getFontMetrics().stringWidth(title);
        float points = (float) Math.min(18, 18 * (width - 20) / wide);
        graphics.setFont(graphics.getFont().deriveFont(points));
        wide = graphics.getFontMetrics().stringWidth(title);
        graphics.drawString(title, (float) (width - wide) / 2, 26);
    }

    private XYChart chart(Axis axis, Texts texts, ChartLook paper) {
        XYChart chart =
                new XYChartBuilder()
                        .title(texts.text("growth." + code(axis)))
                        .xAxisTitle(texts.text("growth." + code(axis) + ".axis"))
                        .yAxisTitle(texts.text("growth.work"))
                        .build();
        paper.style(chart.getStyler(), texts.locale());
        style(chart.getStyler());
        var names = new LineNames(paper.ink());
        chart.addAnnotation(names);
        for (String method : methods) {
            Growth growth = growth(method, axis);
            int last = growth.sizes().length - 1;
            names.add(
                    method,
                    growth.sizes()[last],
                    growth.work()[last],
                    look(method).on(paper).color());
            XYSeries series =
                    chart.addSeries(
                            method,
                            Arrays.stream(growth.sizes()).asDoubleStream().toArray(),
                            Arrays.stream(growth.work()).asDoubleStream().toArray());
            look(method).on(paper).style(series);
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
        styler.setXAxisTickLabelsFormattingFunction(PowersOfTen::nearest);
        styler.setYAxisTickLabelsFormattingFunction(PowersOfTen::nearest);
        styler.setLegendVisible(false);
        styler.setMarkerSize(5);
        styler.setBaseFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        styler.setChartTitleFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
    }
}
