package rasterlab.exercises.drawing;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.image.BufferedImage;
import java.util.List;
import rasterlab.engine.raster.Pixel;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;

/**
 * Draws a right answer of pixels, with what is given: numbered columns and rows, rows downwards,
 * lit pixels as squares, given ones of another colour crossed, and exact curves over them.
 */
public final class AnswerGrid {
    private static final int SIDE = 320;
    private static final int SMALLEST_CELL = 6;
    private static final int LARGEST_CELL = 28;
    private static final int LEAST_MARGIN = 26;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 11);
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);
    private static final Color CURVE = new Color(0xD55E00);

    private final PixelWindow shown;
    private final int cell;
    private final int margin;

    /**
     * @param shown at most 80 columns and 60 rows
     */
    public AnswerGrid(PixelWindow shown) {
        this.shown = shown;
        int longest = (int) Math.max(shown.width(), shown.height());
        cell = Math.max(SMALLEST_CELL, Math.min(LARGEST_CELL, SIDE / longest));
        margin = Math.max(LEAST_MARGIN, 9 + Math.max(width(shown.ymin()), width(shown.ymax())));
    }

    /**
     * The picture as PNG.
     *
     * @param lit the pixels of the answer
     * @param blocked given pixels that differ from those where the method begins
     * @param curves what the pixels stand for, where whole numbers are centres of pixels
     * @param begin pixels where the method begins, which are ringed
     */
    public byte[] png(PixelSet lit, PixelSet blocked, List<Shape> curves, List<Pixel> begin) {
        var image =
                new BufferedImage(
                        margin + (int) shown.width() * cell + 1,
                        margin + (int) shown.height() * cell + 1,
                        BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(Ink.PAPER);
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        lines(g);
        numbers(g);
        g.setColor(Ink.EXPECTED);
        for (int i = 0; i < lit.size(); i++)
            if (shown.contains(lit.x(i), lit.y(i)))
                g.fillRect(left(lit.x(i)) + 2, top(lit.y(i)) + 2, cell - 3, cell - 3);
        for (int i = 0; i < blocked.size(); i++)
            if (shown.contains(blocked.x(i), blocked.y(i))) cross(g, blocked.x(i), blocked.y(i));
        begin.forEach(one -> ring(g, one));
        curves(g, curves);
        g.dispose();
        return PngBytes.small(image);
    }

    private int left(long x) {
        return margin + (int) (x - shown.xmin()) * cell;
    }

    private int top(long y) {
        return margin + (int) (y - shown.ymin()) * cell;
    }

    private void lines(Graphics2D g) {
        g.setColor(Ink.GRID);
        int right = left(shown.xmax() + 1L);
        int bottom = top(shown.ymax() + 1L);
        for (int x = margin; x <= right; x += cell) g.drawLine(x, margin, x, bottom);
        for (int y = margin; y <= bottom; y += cell) g.drawLine(margin, y, right, y);
    }

    /** Writes every number where there is place for all, else every fifth, or tenth. */
    private void numbers(Graphics2D g) {
        g.setFont(FONT);
        g.setColor(Ink.LABEL);
        FontMetrics metrics = g.getFontMetrics();
        int widest = Math.max(width(shown.xmin()), width(shown.xmax()));
        int apart = widest + 4 <= cell ? 1 : widest + 4 <= 5 * cell ? 5 : 10;
        for (long x = shown.xmin(); x <= shown.xmax(); x++)
            if (x % apart == 0) {
                String text = text(x);
                int indent = (cell - metrics.stringWidth(text)) / 2;
                g.drawString(text, left(x) + indent, margin - 6);
            }
        int aligned = (cell + metrics.getAscent() - metrics.getDescent()) / 2;
        for (long y = shown.ymin(); y <= shown.ymax(); y++)
            if (y % apart == 0)
                g.drawString(text(y), margin - 5 - metrics.stringWidth(text(y)), top(y) + aligned);
    }

    private static int width(long number) {
        return (int) Math.ceil(FONT.getStringBounds(text(number), CONTEXT).getWidth());
    }

    private static String text(long number) {
        return (number < 0 ? "−" : "") + Math.abs(number);
    }

    private void cross(Graphics2D g, int x, int y) {
        g.setColor(Ink.pale(Ink.GIVEN));
        g.fillRect(left(x) + 2, top(y) + 2, cell - 3, cell - 3);
        g.setColor(Ink.GIVEN);
        g.setStroke(new BasicStroke(1.4f));
        int inset = cell / 4;
        g.drawLine(left(x) + inset, top(y) + inset, left(x) + cell - inset, top(y) + cell - inset);
        g.drawLine(left(x) + cell - inset, top(y) + inset, left(x) + inset, top(y) + cell - inset);
    }

    private void ring(Graphics2D g, Pixel at) {
        double size = cell * 0.5;
        var ring =
                new Ellipse2D.Double(
                        left(at.x()) + (cell - size) / 2,
                        top(at.y()) + (cell - size) / 2,
                        size,
                        size);
        stroked(g, ring);
    }

    private void curves(Graphics2D g, List<Shape> curves) {
        g.clipRect(margin, margin, (int) shown.width() * cell + 1, (int) shown.height() * cell + 1);
        var place = new AffineTransform();
        place.translate(margin + cell / 2.0, margin + cell / 2.0);
        place.scale(cell, cell);
        place.translate(-shown.xmin(), -shown.ymin());
        for (Shape one : curves) stroked(g, place.createTransformedShape(one));
    }

    /** Draws a shape so that it is seen on paper and on lit pixels alike. */
    private static void stroked(Graphics2D g, Shape shape) {
        g.setColor(Ink.PAPER);
        g.setStroke(new BasicStroke(4f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(shape);
        g.setColor(CURVE);
        g.setStroke(new BasicStroke(1.8f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(shape);
    }
}
