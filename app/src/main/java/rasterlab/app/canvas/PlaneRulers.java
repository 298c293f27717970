package rasterlab.app.canvas;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.util.Locale;

/** Grid lines at round numbers of a plane, its axes, and the numbers along two margins. */
final class PlaneRulers {
    /** View units between grid lines, at least. */
    private static final double APART = 28;

    /** Beyond so many lines the numbers are too far from 0 to be told apart in doubles. */
    private static final int MOST = 1000;

    /** Share of the usual size below which a number is written with a power of ten instead. */
    private static final double SMALLEST = 0.75;

    private final PlaneMap map;
    private final Dimension view;
    private final StageColours colours;
    private final Font font;
    private final Locale locale;

    /**
     * @param font of a label; the numbers are smaller
     */
    PlaneRulers(PlaneMap map, Dimension view, StageColours colours, Font font, Locale locale) {
        this.map = map;
        this.view = view;
        this.colours = colours;
        this.font = font.deriveFont(Font.PLAIN, font.getSize2D() * 11 / 13);
        this.locale = locale;
    }

    void paintGrid(Graphics2D g) {
        g.setColor(colours.ground());
        g.fillRect(0, 0, view.width, view.height);
        RoundTicks columns = RoundTicks.atLeast(map.worldWidth(APART));
        each(
                columns,
                leftWorld(),
                rightWorld(),
                x -> vertical(g, columns.value(x), colours.grid()));
        RoundTicks rows = RoundTicks.atLeast(map.worldHeight(APART));
        each(rows, lowWorld(), highWorld(), y -> horizontal(g, rows.value(y), colours.grid()));
        vertical(g, 0, colours.axis());
        horizontal(g, 0, colours.axis());
    }

    void paintMargins(Graphics2D g) {
        g.setColor(colours.margin());
        g.fillRect(0, 0, view.width, Rulers.top());
        g.fillRect(0, 0, Rulers.left(), view.height);
        g.setColor(colours.axis());
        g.drawLine(Rulers.left(), Rulers.top(), view.width, Rulers.top());
        g.drawLine(Rulers.left(), Rulers.top(), Rulers.left(), view.height);
        g.setFont(font);
        g.setColor(colours.ink());
        paintColumns(g);
        paintRows(g);
        g.setColor(colours.margin());
        g.fillRect(0, 0, Rulers.left(), Rulers.top());
        g.setColor(colours.ink());
        String corner = "y\\x";
        FontMetrics metrics = g.getFontMetrics();
        g.drawString(corner, Rulers.left() - 6 - metrics.stringWidth(corner), baseline(metrics));
    }

    private void paintColumns(Graphics2D g) {
        FontMetrics metrics = g.getFontMetrics();
        RoundTicks ticks = columnsWithRoom(metrics);
        each(
                ticks,
                leftWorld(),
                rightWorld(),
                tick -> {
                    String number = ticks.shown(tick, locale);
                    int wide = metrics.stringWidth(number);
                    int at = (int) Math.round(map.viewX(ticks.value(tick)) - wide / 2.0);
                    if (at > Rulers.left() && at + wide < view.width)
                        g.drawString(number, at, baseline(metrics));
                });
    }

    /** The closest ticks whose numbers do not touch. */
    private RoundTicks columnsWithRoom(FontMetrics metrics) {
        double apart = APART;
        while (true) {
            RoundTicks ticks = RoundTicks.atLeast(map.worldWidth(apart));
            int widest =
                    Math.max(wide(metrics, ticks, leftWorld()), wide(metrics, ticks, rightWorld()));
            if (ticks.step() * map.scaleX() >= widest + 12 || apart > view.width) return ticks;
            apart *= 1.5;
        }
    }

    private int wide(FontMetrics metrics, RoundTicks ticks, double world) {
        return metrics.stringWidth(ticks.shown(ticks.before(world), locale));
    }

    private void paintRows(Graphics2D g) {
        FontMetrics metrics = g.getFontMetrics();
        RoundTicks ticks = RoundTicks.atLeast(map.worldHeight(APART));
        FontMetrics smallest =
                g.getFontMetrics(font.deriveFont((float) (SMALLEST * font.getSize2D())));
        boolean full =
                fits(ticks.shown(ticks.before(lowWorld()) + 1, locale), smallest)
                        && fits(ticks.shown(ticks.before(highWorld()), locale), smallest);
        each(
                ticks,
                lowWorld(),
                highWorld(),
                tick -> {
                    String number =
                            full ? ticks.shown(tick, locale) : ticks.shown(tick, locale, true);
                    double middle = map.viewY(ticks.value(tick));
                    int at = (int) Math.round(middle + metrics.getAscent() / 2.0 - 1);
                    if (at - metrics.getAscent() >= Rulers.top() && at < view.height)
                        paintRow(g, number, at);
                });
    }

    private void paintRow(Graphics2D g, String number, int base) {
        g.setFont(fitting(number, g));
        g.drawString(number, Rulers.left() - 6 - g.getFontMetrics().stringWidth(number), base);
        g.setFont(font);
    }

    /** The font, smaller where a number is too long for the left margin. */
    private Font fitting(String number, Graphics2D g) {
        float size = font.getSize2D();
        while (size > 1 && !fits(number, g.getFontMetrics(font.deriveFont(size)))) size -= 0.5f;
        return font.deriveFont(size);
    }

    private static boolean fits(String number, FontMetrics metrics) {
        return metrics.stringWidth(number) <= Rulers.left() - 8;
    }

    private static int baseline(FontMetrics metrics) {
        return (Rulers.top() + metrics.getAscent() - metrics.getDescent()) / 2 + 1;
    }

    private interface Tick {
        void paint(long tick);
    }

    private static void each(RoundTicks ticks, double from, double to, Tick painted) {
        if (!(Math.abs(from / ticks.step()) < 1e15 && Math.abs(to / ticks.step()) < 1e15)) return;
        long first = ticks.before(from);
        long last = ticks.before(to);
        if (last - first > MOST) return;
        for (long tick = first; tick <= last; tick++) painted.paint(tick);
    }

    private double leftWorld() {
        return map.worldX(Rulers.left());
    }

    private double rightWorld() {
        return map.worldX(view.width);
    }

    private double lowWorld() {
        return Math.min(map.worldY(Rulers.top()), map.worldY(view.height));
    }

    private double highWorld() {
        return Math.max(map.worldY(Rulers.top()), map.worldY(view.height));
    }

    private void vertical(Graphics2D g, double worldX, Color colour) {
        double x = Math.rint(map.viewX(worldX));
        if (!(x >= Rulers.left() && x <= view.width)) return;
        g.setColor(colour);
        g.drawLine((int) x, Rulers.top(), (int) x, view.height);
    }

    private void horizontal(Graphics2D g, double worldY, Color colour) {
        double y = Math.rint(map.viewY(worldY));
        if (!(y >= Rulers.top() && y <= view.height)) return;
        g.setColor(colour);
        g.drawLine(Rulers.left(), (int) y, view.width, (int) y);
    }
}
