package rasterlab.app.canvas;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.font.FontRenderContext;
import java.awt.font.LineMetrics;
import java.util.ArrayList;
import java.util.List;

/**
 * A sentence at a stage's upper edge, wrapped to the stage's width.
 *
 * <p>At least half of the stage is left to the picture: a sentence that would take more is set in
 * smaller type, and cut where that is still too much.
 */
public final class StageNote {
    /** View units above the sentence. */
    private static final int ABOVE = 10;

    /** View units on both sides of the sentence. */
    private static final int BESIDE = 14;

    /** View units between its lines. */
    private static final int APART = 2;

    /**
     * Sizes of its type where it is too long, as shares of the usual one; the last is the least.
     */
    private static final float[] SIZES = {1, 0.85f, 0.75f};

    /** Measures texts on every thread, whatever it draws on. */
    private static final FontRenderContext MEASURE = new FontRenderContext(null, true, false);

    private final Rectangle inside;
    private final int most;
    private Font font;
    private List<String> lines = List.of();

    /**
     * @param sentence "" for none
     * @param inside what rulers leave of the stage
     * @param label font of a label
     */
    public StageNote(String sentence, Rectangle inside, Font label) {
        this.inside = inside;
        most = inside.height / 2;
        font = label.deriveFont(Font.BOLD);
        if (sentence.isEmpty()) return;
        for (float size : SIZES) {
            font = label.deriveFont(Font.BOLD, size * label.getSize2D());
            lines = Wrapping.lines(sentence, inside.width - 2 * BESIDE, this::width);
            if (high(lines.size()) <= most) return;
        }
        lines = cut();
    }

    private int width(String line) {
        return (int) Math.ceil(font.getStringBounds(line, MEASURE).getWidth());
    }

    private int high(int count) {
        return ABOVE + count * pitch();
    }

    /** View units from line to line. */
    private int pitch() {
        return (int) Math.ceil(font.getLineMetrics("", MEASURE).getHeight()) + APART;
    }

    /** The lines that there is room for, at least one; the last one says that there are more. */
    private List<String> cut() {
        int count = Math.max(1, (most - ABOVE) / pitch());
        if (count >= lines.size()) return lines;
        var kept = new ArrayList<>(lines.subList(0, count));
        String last = kept.get(count - 1);
        while (!last.isEmpty() && width(last + "…") > inside.width - 2 * BESIDE)
            last = last.substring(0, last.length() - 1);
        kept.set(count - 1, last + "…");
        return kept;
    }

    /**
     * The part of the stage that rulers and the sentence leave free, at least half of that beside
     * the rulers.
     */
    public Rectangle below() {
        if (lines.isEmpty()) return inside;
        // A picture that moved with each longer word would not stand still while it is dragged.
        int high = Math.min(high(Math.max(2, lines.size())), most);
        return new Rectangle(inside.x, inside.y + high, inside.width, inside.height - high);
    }

    /**
     * Paints the lines that there is room for, each on a plate.
     *
     * @param g in view units; keeps its font
     */
    public void paint(Graphics2D g, StageColors colors) {
        Font before = g.getFont();
        g.setFont(font);
        LineMetrics metrics = font.getLineMetrics("", MEASURE);
        int y = inside.y + ABOVE + Math.round(metrics.getAscent());
        for (String line : lines) {
            Plates.plate(
                    g,
                    line,
                    inside.x + BESIDE,
                    y,
                    Plates.nearlyOpaque(colors.ground()),
                    colors.ink());
            y += pitch();
        }
        g.setFont(before);
    }
}
