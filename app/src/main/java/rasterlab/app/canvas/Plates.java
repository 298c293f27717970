package rasterlab.app.canvas;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.util.List;

/** Words on a rounded plate, so that they can be read over any picture. */
public final class Plates {
    private static final int OPAQUE = 225;

    private Plates() {}

    /**
     * @param x view x where the text begins
     * @param y view y of its base line
     */
    public static void plate(Graphics2D g, String text, int x, int y, Color plate, Color ink) {
        FontMetrics metrics = g.getFontMetrics();
        g.setColor(plate);
        g.fillRoundRect(
                x - 4,
                y - metrics.getAscent() - 1,
                metrics.stringWidth(text) + 8,
                metrics.getHeight() + 1,
                8,
                8);
        g.setColor(ink);
        g.drawString(text, x, y);
    }

    /**
     * A colour for the ground under words that should be read rather than what lies behind them.
     */
    public static Color nearlyOpaque(Color ground) {
        return new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), OPAQUE);
    }

    /**
     * Writes a sentence over the lower part of a picture, wrapped to its width.
     *
     * @param width of the picture
     * @param bottom view y below which nothing is written
     */
    public static void sentenceAbove(Graphics2D g, String sentence, int width, int bottom) {
        FontMetrics metrics = g.getFontMetrics();
        StageColors colors = StageColors.now();
        Color plate = nearlyOpaque(colors.ground());
        List<String> lines = Wrapping.lines(sentence, width - 48, metrics::stringWidth);
        int high = metrics.getHeight() + 2;
        int y = bottom - high * lines.size();
        for (String line : lines) plate(g, line, 24, y += high, plate, colors.ink());
    }
}
