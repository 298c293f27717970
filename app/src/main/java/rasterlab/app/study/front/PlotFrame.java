package rasterlab.app.study.front;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.study.chart.LogTicks;

/** Title, axes, grid and notes of a chart around its plot. */
final class PlotFrame {
    private static final Font TITLE = new Font(Font.SANS_SERIF, Font.BOLD, 17);
    private static final Font AXIS = new Font(Font.SANS_SERIF, Font.PLAIN, 13);
    private static final Font NUMBER = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private static final Font NOTE = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    private static final int NOTE_ROW = 14;

    /** The least distance between two numbers. */
    private static final int GAP = 6;

    private final Graphics2D graphics;
    private final ChartLook paper;
    private final Rectangle2D plot;
    private final Locale locale;

    /**
     * @param plot in the chart's own units
     */
    PlotFrame(Graphics2D graphics, ChartLook paper, Rectangle2D plot, Locale locale) {
        this.graphics = graphics;
        this.paper = paper;
        this.plot = plot;
        this.locale = locale;
        graphics.setRenderingHint(
                RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setRenderingHint(
                RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    }

    /** A little of the ink on the ground. */
    Color pale(int alpha) {
        Color ink = paper.ink();
        return new Color(ink.getRed(), ink.getGreen(), ink.getBlue(), alpha);
    }

    /** Writes a title in the middle over the whole width, smaller where it would not fit. */
    void title(String text, double width) {
        int wide = graphics.getFontMetrics(TITLE).stringWidth(text);
        float size = (float) Math.min(TITLE.getSize2D(), TITLE.getSize2D() * (width - 20) / wide);
        graphics.setFont(TITLE.deriveFont(size));
        graphics.setColor(paper.ink());
        int drawn = graphics.getFontMetrics().stringWidth(text);
        graphics.drawString(text, (float) Math.max(10, (width - drawn) / 2), 24);
    }

    /** Draws the axis to the right with its words below. */
    void axisRight(LogScale scale, String words) {
        axisRight(scale, scale.ticks(), words);
    }

    /**
     * Draws the axis to the right with its words below.
     *
     * @param ticks from the left; the first and the last have a number, those between where it has
     *     room
     */
    void axisRight(LogScale scale, List<Double> ticks, String words) {
        graphics.setFont(NUMBER);
        int last = ticks.size() - 1;
        double end = Double.NEGATIVE_INFINITY;
        for (int i = 0; i <= last; i++) {
            double x = scale.at(ticks.get(i));
            graphics.setColor(pale(40));
            graphics.setStroke(new BasicStroke(1));
            graphics.draw(new Line2D.Double(x, plot.getMinY(), x, plot.getMaxY()));
            double right = x + width(ticks.get(i)) / 2;
            boolean before = i == last || right + GAP < left(scale, ticks.get(last));
            if (!before || left(scale, ticks.get(i)) < end + GAP) continue;
            end = right;
            graphics.setColor(paper.ink());
            graphics.drawString(
                    LogTicks.label(ticks.get(i), locale),
                    (float) left(scale, ticks.get(i)),
                    (float) plot.getMaxY() + 17);
        }
        middle(AXIS, words, plot.getCenterX(), plot.getMaxY() + 36);
    }

    private double left(LogScale scale, double tick) {
        return scale.at(tick) - width(tick) / 2;
    }

    private double width(double tick) {
        return graphics.getFontMetrics(NUMBER).stringWidth(LogTicks.label(tick, locale));
    }

    /** Draws the axis upwards with its words beside, read from below. */
    void axisUp(LogScale scale, String words) {
        graphics.setFont(NUMBER);
        FontMetrics metrics = graphics.getFontMetrics();
        for (double tick : scale.ticks()) {
            double y = scale.at(tick);
            graphics.setColor(pale(40));
            graphics.setStroke(new BasicStroke(1));
            graphics.draw(new Line2D.Double(plot.getMinX(), y, plot.getMaxX(), y));
            graphics.setColor(paper.ink());
            String said = LogTicks.label(tick, locale);
            graphics.drawString(
                    said,
                    (float) plot.getMinX() - 6 - metrics.stringWidth(said),
                    (float) y + metrics.getAscent() / 2f - 1);
        }
        wordsUp(words);
    }

    void wordsUp(String words) {
        AffineTransform before = graphics.getTransform();
        graphics.rotate(-Math.PI / 2, plot.getMinX() - 58, plot.getCenterY());
        middle(AXIS, words, plot.getMinX() - 58, plot.getCenterY());
        graphics.setTransform(before);
    }

    /** Writes a word at the left of the plot, at a height of its own. */
    void besideLeft(String word, double y) {
        graphics.setFont(NUMBER);
        graphics.setColor(paper.ink());
        FontMetrics metrics = graphics.getFontMetrics();
        graphics.drawString(
                word,
                (float) plot.getMinX() - 6 - metrics.stringWidth(word),
                (float) y + metrics.getAscent() / 2f - 1);
    }

    void border() {
        graphics.setColor(pale(150));
        graphics.setStroke(new BasicStroke(1));
        graphics.draw(plot);
    }

    private void middle(Font font, String words, double x, double y) {
        graphics.setFont(font);
        graphics.setColor(paper.ink());
        int wide = graphics.getFontMetrics().stringWidth(words);
        graphics.drawString(words, (float) (x - wide / 2.0), (float) y);
    }

    /** The lines that a note takes in that width. */
    static List<String> noteLines(String note, double width, Graphics2D graphics) {
        FontMetrics metrics = graphics.getFontMetrics(NOTE);
        return Wrapping.lines(note, (int) width, metrics::stringWidth);
    }

    static int noteHeight(List<String> lines) {
        return lines.size() * NOTE_ROW;
    }

    /**
     * Lines of small words.
     *
     * @param top of the first
     */
    void note(List<String> lines, double left, double top) {
        graphics.setFont(NOTE);
        graphics.setColor(paper.note());
        for (int i = 0; i < lines.size(); i++)
            graphics.drawString(lines.get(i), (float) left, (float) top + (i + 1) * NOTE_ROW - 3);
    }
}
