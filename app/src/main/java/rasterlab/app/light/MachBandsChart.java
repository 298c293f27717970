package rasterlab.app.light;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.XYSeries;
import org.knowm.xchart.style.Styler.LegendPosition;
import org.knowm.xchart.style.XYStyler;
import org.knowm.xchart.style.markers.SeriesMarkers;
import rasterlab.app.canvas.MethodColours;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.ChartPicture;
import rasterlab.engine.light.face.BrightnessProfile;
import rasterlab.engine.light.face.MachBands;

/** Brightness along the equator of a faceted sphere by flat, Gouraud's and Phong's shading. */
public final class MachBandsChart {
    private static final int PER_FACE = 51;
    private static final double HALF_TURN = 180;
    private static final Color[] COLOURS = {
        MethodColours.ORANGE, MethodColours.BLUE, MethodColours.GREEN
    };

    private MachBandsChart() {}

    /** The curves by the names of the shadings. */
    public static Map<String, BrightnessProfile> profiles() {
        Map<String, BrightnessProfile> profiles = new LinkedHashMap<>();
        for (String shading : MachBands.SHADINGS)
            profiles.put(shading, MachBands.profile(shading, PER_FACE));
        return profiles;
    }

    /** Degrees of longitude of each sample; the edge of two faces stands there twice. */
    private static double[] longitudes() {
        double[] degrees = new double[PER_FACE * MachBands.FACETS];
        for (int i = 0; i < degrees.length; i++) {
            double faces = i / PER_FACE + i % PER_FACE / (PER_FACE - 1.0);
            degrees[i] = HALF_TURN * (faces / MachBands.FACETS - 0.5);
        }
        return degrees;
    }

    public static BufferedImage image(Language language) {
        return ChartPicture.image(
                graphics ->
                        chart(language).paint(graphics, ChartPicture.WIDTH, ChartPicture.HEIGHT));
    }

    public static byte[] svg(Language language) {
        return ChartPicture.svg(
                graphics ->
                        chart(language).paint(graphics, ChartPicture.WIDTH, ChartPicture.HEIGHT));
    }

    /** The points of the curves as comma-separated values. */
    public static String csv() {
        var rows = new StringJoiner("\r\n", "", "\r\n");
        rows.add("longitude," + String.join(",", MachBands.SHADINGS));
        double[] longitudes = longitudes();
        var profiles = profiles().values();
        for (int i = 0; i < longitudes.length; i++) {
            var row = new StringJoiner(",").add("" + longitudes[i]);
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
                        .xAxisTitle(texts.text("longitude"))
                        .yAxisTitle(texts.text("brightness"))
                        .build();
        style(chart.getStyler());
        int colour = 0;
        for (var profile : profiles().entrySet()) {
            XYSeries series =
                    chart.addSeries(
                            texts.text(profile.getKey()),
                            longitudes(),
                            profile.getValue().brightness());
            series.setMarker(SeriesMarkers.NONE);
            series.setLineColor(COLOURS[colour++]);
            series.setLineStyle(new BasicStroke(3f));
        }
        return chart;
    }

    private static void style(XYStyler styler) {
        styler.setXAxisMin(-HALF_TURN / 2).setXAxisMax(HALF_TURN / 2);
        styler.setYAxisMin(0.0).setYAxisMax(1.0);
        styler.setLegendPosition(LegendPosition.InsideNW);
        styler.setLocale(Locale.ROOT);
        styler.setXAxisDecimalPattern("#").setYAxisDecimalPattern("#.#");
        styler.setBaseFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        styler.setLegendFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        styler.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 18));
        styler.setChartTitleBoxVisible(false);
        styler.setChartBackgroundColor(Color.WHITE);
        styler.setPlotBackgroundColor(Color.WHITE);
    }
}
