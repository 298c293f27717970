package rasterlab.app.light;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.StringJoiner;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.light.face.BrightnessProfile;
import rasterlab.engine.light.face.MachBands;

/** Brightness along the equator of a faceted sphere by flat, Gouraud's and Phong's shading. */
public final class MachBandsChart {
    private static final int PER_FACE = 51;
    private static final Color[] COLORS = {
        MethodColors.ORANGE, MethodColors.BLUE, MethodColors.GREEN
    };

    private MachBandsChart() {}

    /** The curves by the names of the shadings. */
    public static Map<String, BrightnessProfile> profiles() {
        Map<String, BrightnessProfile> profiles = new LinkedHashMap<>();
        for (String shading : MachBands.SHADINGS)
            profiles.put(shading, MachBands.profile(shading, PER_FACE));
        return profiles;
    }

    /** How many faces from the western rim each sample is; an edge of two faces is there twice. */
    private static double[] places() {
        double[] faces = new double[PER_FACE * MachBands.FACETS];
        for (int i = 0; i < faces.length; i++)
            faces[i] = i / PER_FACE + i % PER_FACE / (PER_FACE - 1.0);
        return faces;
    }

    /**
     * The places a little uneven: evenly spaced ones would be taken for the only ones that an axis
     * may name.
     */
    private static double[] uneven(double[] places) {
        for (int i = 0; i < places.length; i += PER_FACE) places[i] += 1e-3;
        return places;
    }

    public static BufferedImage image(Language language) {
        return ChartLook.PAPER.image(
                graphics -> chart(language).paint(graphics, ChartLook.WIDTH, ChartLook.HEIGHT));
    }

    public static byte[] svg(Language language) {
        return ChartLook.PAPER.svg(
                graphics -> chart(language).paint(graphics, ChartLook.WIDTH, ChartLook.HEIGHT));
    }

    /** The points of the curves as comma-separated values. */
    public static String csv() {
        var rows = new StringJoiner("\r\n", "", "\r\n");
        rows.add("faces," + String.join(",", MachBands.SHADINGS));
        double[] places = places();
        var profiles = profiles().values();
        for (int i = 0; i < places.length; i++) {
            var row = new StringJoiner(",").add("" + places[i]);
            for (BrightnessProfile profile : profiles) row.add("" + profile.brightness()[i]);
            rows.add(row.toString());
        }
        return rows.toString();
    }

    private static XYChart chart(Language language) {
        Texts texts = Texts.of("light", language);
        XYChart chart =
                new XYChartBuilder()
                        .title(texts.text("title"))
                        .xAxisTitle(texts.text("equator"))
                        .yAxisTitle(texts.text("brightness"))
                        .build();
        ChartLook.PAPER.style(chart.getStyler(), texts.locale());
        style(chart.getStyler());
        int color = 0;
        for (var profile : profiles().entrySet()) {
            XYSeries series =
                    chart.addSeries(
                            texts.text(profile.getKey()),
                            uneven(places()),
                            profile.getValue().brightness());
            series.setMarker(SeriesMarkers.NONE);
            series.setLineColor(COLORS[color++]);
            series.setLineStyle(new BasicStroke(3f));
        }
        return chart;
    }

    private static void style(XYStyler styler) {
        styler.setXAxisMin(0.0).setXAxisMax((double) MachBands.FACETS);
        styler.setYAxisMin(0.0).setYAxisMax(1.0);
        styler.setLegendPosition(LegendPosition.InsideNW);
        styler.setXAxisDecimalPattern("#.##").setYAxisDecimalPattern("#.#");
        styler.setLegendFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
    }
}
