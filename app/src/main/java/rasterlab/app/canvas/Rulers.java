package rasterlab.app.canvas;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;

/** Grid lines between pixels, the axes, and the coordinates along the upper and left margin. */
public final class Rulers {
    /** The view units per pixel below which the grid would be grey. */
    private static final double FINEST_GRID = 5;

    private final ZoomedGrid grid;
    private final Dimension view;
    private final StageColors colors;
    private final Font font;

    /**
     * @param font of a label; the numbers are smaller
     */
    public Rulers(ZoomedGrid grid, Dimension view, StageColors colors, Font font) {
        this.grid = grid;
        this.view = view;
        this.colors = colors;
        this.font = font.deriveFont(Font.PLAIN, PictureType.scaled(11f));
    }

    /** Height of the upper margin in view units. */
    public static int top() {
        return PictureType.scaled(22);
    }

    /** Width of the left margin in view units. */
    public static int left() {
        return PictureType.scaled(44);
    }

    /** The part of the view that the margins leave free. */
    public static Rectangle inside(Dimension view) {
        return new Rectangle(
                left(), top(), Math.max(1, view.width - left()), Math.max(1, view.height - top()));
    }

    /** Where a square of that size begins, so that its middle is at {@code view} if it fits. */
    public static int square(double view, int from, int to, int size) {
        return (int) Math.round(Math.max(from, Math.min(to - size, view - size / 2.0)));
    }

    public void paintGrid(Graphics2D g) {
        g.setColor(colors.ground());
        g.fillRect(0, 0, view.width, view.height);
        Point first = grid.pixelAt(left(), top());
        Point last = grid.pixelAt(view.width, view.height);
        if (grid.cell() >= FINEST_GRID) {
            for (long x = first.x; x <= last.x + 1L; x++)
                vertical(g, grid.viewX(x - 0.5), colors.grid());
            for (long y = first.y; y <= last.y + 1L; y++)
                horizontal(g, grid.viewY(y - 0.5), colors.grid());
        }
        vertical(g, grid.viewX(0), colors.axis());
        horizontal(g, grid.viewY(0), colors.axis());
    }

    public void paintMargins(Graphics2D g) {
        g.setColor(colors.margin());
        g.fillRect(0, 0, view.width, top());
        g.fillRect(0, 0, left(), view.height);
        g.setColor(colors.axis());
        g.drawLine(left(), top(), view.width, top());
        g.drawLine(left(), top(), left(), view.height);
        g.setFont(font);
        g.setColor(colors.ink());
        paintNumbers(g);
        g.setColor(colors.margin());
        g.fillRect(0, 0, left(), top());
        g.setColor(colors.ink());
        g.drawString("y\\x", left() - PictureType.scaled(24), baseline());
    }

    private void paintNumbers(Graphics2D g) {
        FontMetrics metrics = g.getFontMetrics();
        Point first = grid.pixelAt(left(), top());
        Point last = grid.pixelAt(view.width, view.height);
        int widest =
                Math.max(metrics.stringWidth(shown(first.x)), metrics.stringWidth(shown(last.x)));
        long stepX = step((widest + 12) / grid.cell());
        for (long x = Math.floorDiv(first.x, stepX) * stepX; x <= last.x; x += stepX) {
            String number = shown(x);
            int at = (int) Math.round(grid.viewX(x) - metrics.stringWidth(number) / 2.0);
            if (at > left() && at + metrics.stringWidth(number) < view.width)
                g.drawString(number, at, baseline());
        }
        long stepY = step(top() / grid.cell());
        for (long y = Math.floorDiv(first.y, stepY) * stepY; y <= last.y; y += stepY) {
            String number = shortened(y);
            int at = (int) Math.round(grid.viewY(y) + metrics.getAscent() / 2.0 - 1);
            if (at - metrics.getAscent() >= top() && at < view.height)
                g.drawString(number, left() - 6 - metrics.stringWidth(number), at);
        }
    }

    private static int baseline() {
        return PictureType.scaled(15);
    }

    /** A number that fits the left margin: of a long one, the end, which is what changes. */
    private static String shortened(long number) {
        String digits = shown(number);
        return digits.length() <= 5 ? digits : "…" + digits.substring(digits.length() - 4);
    }

    /** The number with a minus as long as a digit is wide, as in the inspector. */
    private static String shown(long number) {
        return Long.toString(number).replace('-', '−');
    }

    /** The least of 1, 2, 5, 10, 20, … that is at least {@code pixels}. */
    private static long step(double pixels) {
        long step = 1;
        for (int i = 0; step < pixels; i++) step = step * (i % 3 == 1 ? 5 : 4) / 2;
        return step;
    }

    private void vertical(Graphics2D g, double viewX, Color color) {
        int x = (int) Math.round(viewX);
        if (x < left() || x > view.width) return;
        g.setColor(color);
        g.drawLine(x, top(), x, view.height);
    }

    private void horizontal(Graphics2D g, double viewY, Color color) {
        int y = (int) Math.round(viewY);
        if (y < top() || y > view.height) return;
        g.setColor(color);
        g.drawLine(left(), y, view.width, y);
    }
}
