package rasterlab.app.chart;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.function.Consumer;
import org.knowm.xchart.style.XYStyler;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.app.canvas.method.MethodColors;

/**
 * The colours of a chart of {@link #WIDTH} × {@link #HEIGHT} pixels.
 *
 * @param ground behind it
 * @param ink of its words
 */
public record ChartLook(Color ground, Color ink) {
    public static final int WIDTH = 1000;
    public static final int HEIGHT = 700;

    /** The look of files, whatever the window's theme. */
    public static final ChartLook PAPER = new ChartLook(Color.WHITE, Color.BLACK);

    /** Share of the ink in notes and in grid lines. */
    private static final double NOTE = 0.75;

    private static final double GRID = 0.25;

    /** The look of a stage in those colours. */
    public static ChartLook on(StageColors stage) {
        return new ChartLook(stage.ground(), stage.ink());
    }

    /** The chart as a picture. */
    public BufferedImage image(Consumer<Graphics2D> chart) {
        return image(ChartSize.USUAL, chart);
    }

    /** Draws the chart in another size. */
    public BufferedImage image(ChartSize size, Consumer<Graphics2D> chart) {
        var image =
                new BufferedImage(
                        (int) Math.round(size.width() * size.dots()),
                        (int) Math.round(size.height() * size.dots()),
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setColor(ground);
        graphics.fillRect(0, 0, image.getWidth(), image.getHeight());
        graphics.scale(size.dots(), size.dots());
        chart.accept(graphics);
        graphics.dispose();
        return image;
    }

    /** The chart as an SVG document. */
    public byte[] svg(Consumer<Graphics2D> chart) {
        return SvgPicture.of(WIDTH, HEIGHT, graphics -> draw(chart, graphics))
                .document()
                .getBytes(StandardCharsets.UTF_8);
    }

    private void draw(Consumer<Graphics2D> chart, Graphics2D graphics) {
        graphics.setColor(ground);
        graphics.fillRect(0, 0, WIDTH, HEIGHT);
        chart.accept(graphics);
    }

    /** Colour of words that explain, and of the lines that lead to them. */
    public Color note() {
        return mixed(NOTE);
    }

    /** A line's colour: on white as it is, elsewhere one that stands out from the ground. */
    public Color line(Color color) {
        return ground.equals(Color.WHITE) ? color : MethodColors.lineOn(ground, color);
    }

    private Color mixed(double share) {
        return new Color(
                mixed(share, ground.getRed(), ink.getRed()),
                mixed(share, ground.getGreen(), ink.getGreen()),
                mixed(share, ground.getBlue(), ink.getBlue()));
    }

    private static int mixed(double share, int from, int to) {
        return (int) Math.round(from + share * (to - from));
    }

    /**
     * Gives a chart these colours and the type that all charts have.
     *
     * @param locale of the numbers at its axes
     */
    public void style(XYStyler styler, Locale locale) {
        styler.setLocale(locale);
        styler.setBaseFont(new Font(Font.SANS_SERIF, Font.PLAIN, 14));
        styler.setChartTitleFont(new Font(Font.SANS_SERIF, Font.BOLD, 18));
        styler.setChartTitleBoxVisible(false);
        styler.setChartBackgroundColor(ground);
        styler.setPlotBackgroundColor(ground);
        styler.setLegendBackgroundColor(ground);
        // beside the plot's border it would be a second one
        styler.setAxisTicksLineVisible(false);
        styler.setChartFontColor(ink);
        styler.setAxisTickLabelsColor(ink);
        styler.setAxisTickMarksColor(mixed(NOTE));
        styler.setPlotBorderColor(mixed(NOTE));
        styler.setLegendBorderColor(mixed(NOTE));
        styler.setPlotGridLinesColor(mixed(GRID));
    }
}
