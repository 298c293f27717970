package rasterlab.app.study;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import rasterlab.app.canvas.SvgPicture;

/** A chart of 1000 × 700 pixels on white, as a picture or an SVG document. */
public final class ChartPicture {
    public static final int WIDTH = 1000;
    public static final int HEIGHT = 700;

    private ChartPicture() {}

    /**
     * @param chart draws the chart
     */
    public static BufferedImage image(Consumer<Graphics2D> chart) {
        var image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        draw(chart, graphics);
        graphics.dispose();
        return image;
    }

    /**
     * @param chart draws the chart
     */
    public static byte[] svg(Consumer<Graphics2D> chart) {
        return SvgPicture.of(WIDTH, HEIGHT, graphics -> draw(chart, graphics))
                .getBytes(StandardCharsets.UTF_8);
    }

    private static void draw(Consumer<Graphics2D> chart, Graphics2D graphics) {
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, WIDTH, HEIGHT);
        chart.accept(graphics);
    }
}
