package rasterlab.app.line.figure;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.StringJoiner;
import java.util.stream.Collectors;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.Styler.LegendPosition;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.trace.LineColors;
import rasterlab.app.line.trace.LineMode;

/** Light that lines get for each pixel of their length, over their angle in degrees. */
public final class BrightnessChart {
    /** The choice that the lab shows first. */
    private static final List<String> USUAL = List.of("bresenham", "naive-textbook");

    private static final double HIGHEST = 1.2;

    /** Characters of a line of the legend, which cuts longer ones. */
    private static final int LEGEND = 60;

    private final Map<String, List<Double>> light = new LinkedHashMap<>();

    /**
     * @param methods of topic {@code line}, of which two of one name are drawn once; none: the two
     *     that the lab shows first
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public BrightnessChart(List<String> methods) {
        var topics = new FigureTopics();
        for (String method : methods.isEmpty() ? USUAL : methods)
            light.put(method, FigureDrawing.brightness(topics, method));
    }

    /** The methods that there are. */
    public static List<String> known() {
        return new FigureTopics().methods(LineMode.SEGMENT);
    }

    /**
     * Passes if all are known.
     *
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static void requireKnown(List<String> methods) {
        var topics = new FigureTopics();
        methods.forEach(method -> topics.line().method(method));
    }

    /** The methods drawn. */
    public List<String> methods() {
        return List.copyOf(light.keySet());
    }

    /** The light at 0°, 1°, …, 90°; NaN where the method draws no line. */
    public List<Double> light(String method) {
        return light.get(method);
    }

    public BufferedImage image(Language language) {
        return ChartLook.PAPER.image(graphics -> paint(graphics, language));
    }

    public byte[] svg(Language language) {
        return ChartLook.PAPER.svg(graphics -> paint(graphics, language));
    }

    /** All points as comma-separated values; a cell is empty where there is no line. */
    public String csv() {
        var rows = new StringJoiner("\r\n", "", "\r\n");
        rows.add("degrees," + String.join(",", methods()));
        for (int degrees = 0; degrees <= SlopeFigure.STEEPEST; degrees++) {
            var row = new StringJoiner(",").add("" + degrees);
            for (List<Double> curve : light.values())
                row.add(curve.get(degrees).isNaN() ? "" : "" + curve.get(degrees));
            rows.add(row.toString());
        }
        return rows.toString();
    }

    private void paint(Graphics2D graphics, Language language) {
        chart(language).paint(graphics, ChartLook.WIDTH, ChartLook.HEIGHT);
    }

    /** A series for each curve that differs from the others. */
    XYChart chart(Language language) {
        Texts texts = Texts.of("line", language);
        XYChart chart =
                new XYChartBuilder()
                        .title(texts.text("chart.brightness"))
                        .xAxisTitle(texts.text("chart.degrees"))
                        .yAxisTitle(texts.text("chart.light"))
                        .build();
        ChartLook.PAPER.style(chart.getStyler(), texts.locale());
        chart.getStyler()
                .setXAxisMin(0.0)
                .setXAxisMax((double) SlopeFigure.STEEPEST)
                .setYAxisMin(0.0)
                .setYAxisMax(HIGHEST);
        chart.getStyler().setLegendPosition(LegendPosition.OutsideS);
        Map<String, MethodLook> looks = MethodLook.of(known(), LineColors.OWN);
        int number = 0;
        for (List<String> alike : alike())
            add(chart, alike, looks.get(alike.get(0)).unmarked(number++));
        return chart;
    }

    /** The methods in their order, those together whose curves are one. */
    private Collection<List<String>> alike() {
        return methods().stream()
                .collect(Collectors.groupingBy(light::get, LinkedHashMap::new, Collectors.toList()))
                .values();
    }

    /**
     * @param alike whose curve this is
     */
    private void add(XYChart chart, List<String> alike, MethodLook look) {
        List<Double> curve = light.get(alike.get(0));
        var degrees = new ArrayList<Integer>();
        var shown = new ArrayList<Double>();
        for (int at = 0; at <= SlopeFigure.STEEPEST; at++) {
            if (curve.get(at).isNaN()) continue;
            degrees.add(at);
            shown.add(curve.get(at));
        }
        if (degrees.isEmpty()) return;
        look.style(chart.addSeries(legend(alike), degrees, shown));
    }

    /** The names with signs of equality between them, in as many lines as they take. */
    private static String legend(List<String> alike) {
        var legend = new StringBuilder(alike.get(0));
        int line = legend.length();
        for (String method : alike.subList(1, alike.size())) {
            boolean fits = line + method.length() < LEGEND;
            legend.append(fits ? " = " : "\n= ").append(method);
            line = legend.length() - legend.lastIndexOf("\n") - 1;
        }
        return legend.toString();
    }
}
