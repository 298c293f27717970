package rasterlab.app.canvas;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.util.List;
import javax.swing.JComponent;

/** Words on a rounded plate, so that they can be read over any picture. */
public final class Plates {
    private static final int OPAQUE = 225;

    /** View units above a sentence at the upper edge. */
    private static final int ABOVE = 10;

    /** View units between its lines. */
    private static final int APART = 2;

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

    /** Under words that should be read rather than what lies behind them. */
    public static Color nearlyOpaque(Color ground) {
        return new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), OPAQUE);
    }

    /**
     * A sentence over the lower part of a picture, wrapped to its width.
     *
     * @param width of the picture
     * @param bottom view y below which nothing is written
     */
    public static void sentenceAbove(Graphics2D g, String sentence, int width, int bottom) {
        FontMetrics metrics = g.getFontMetrics();
        StageColours colours = StageColours.now();
        Color plate = nearlyOpaque(colours.ground());
        List<String> lines = Wrapping.lines(sentence, width - 48, metrics::stringWidth);
        int high = metrics.getHeight() + 2;
        int y = bottom - high * lines.size();
        for (String line : lines) plate(g, line, 24, y += high, plate, colours.ink());
    }

    /**
     * A sentence at the stage's upper edge, beside the rulers and wrapped to the stage's width.
     *
     * @param width of the stage
     */
    public static void sentence(Graphics2D g, String sentence, int width, StageColours colours) {
        g.setFont(g.getFont().deriveFont(Font.BOLD));
        FontMetrics metrics = g.getFontMetrics();
        Color plate = nearlyOpaque(colours.ground());
        int y = Rulers.top() + metrics.getAscent() + ABOVE;
        for (String line : lines(sentence, width, metrics)) {
            plate(g, line, Rulers.left() + 14, y, plate, colours.ink());
            y += metrics.getHeight() + APART;
        }
    }

    /**
     * What rulers and such a sentence leave of a stage, at least half of what the rulers do.
     *
     * @param sentence "" for none
     * @param font of a label
     */
    public static Rectangle below(String sentence, JComponent stage, Font font) {
        Rectangle inside = Rulers.inside(stage.getSize());
        if (sentence.isEmpty()) return inside;
        FontMetrics bold = stage.getFontMetrics(font.deriveFont(Font.BOLD));
        // A picture that moved with each longer word would not stand still while it is dragged.
        int lines = Math.max(2, lines(sentence, stage.getWidth(), bold).size());
        int high = Math.min(ABOVE + lines * (bold.getHeight() + APART), inside.height / 2);
        inside.y += high;
        inside.height -= high;
        return inside;
    }

    private static List<String> lines(String sentence, int width, FontMetrics metrics) {
        return Wrapping.lines(sentence, width - Rulers.left() - 32, metrics::stringWidth);
    }
}
