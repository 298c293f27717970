package rasterlab.app.canvas;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.util.Locale;
import java.util.stream.DoubleStream;

/** Grid lines at round numbers of a plane, its axes, and the numbers along two margins. */
public final class PlaneRulers {
    /** View units between grid lines, at least. */
    private static final double APART = 28;

    /**
     * The number of lines beyond which their numbers are too far from 0 to be told apart in
     * doubles.
     */
    private static final int MOST = 1000;

    /** Share of the usual size below which a number is written with a power of ten instead. */
    private static final double SMALLEST = 0.75;

    /** Whole numbers below this fit the left margin in the usual type. */
    private static final int SHORT = 10_000;

    private final PlaneMap map;
    private final Dimension view;
    private final StageColors colors;
    private final Font font;
    private final Locale locale;
    private final double least;

    /**
     * @param font of a label; the numbers are smaller
     * @param least world units between two lines; 0 for any step
     */
    public PlaneRulers(
            PlaneMap map,
            Dimension view,
            StageColors colors,
            Font font,
            Locale locale,
            double least) {
        this.map = map;
        this.view = view;
        this.colors = colors;
        this.font = font.deriveFont(Font.PLAIN, font.getSize2D() * 11 / 13);
        this.locale = locale;
        this.least = least;
    }

    private RoundTicks ticks(double world) {
        return RoundTicks.atLeast(Math.max(least, world));
    }

    public void paintGrid(Graphics2D g) {
        g.setColor(colors.ground());
        g.fillRect(0, 0, view.width, view.height);
        Numbers numbers = numbers(g);
        RoundTicks columns = equal() ? numbers.columns : ticks(map.worldWidth(APART));
        each(columns, leftWorld(), rightWorld(), x -> vertical(g, columns.value(x), colors.grid()));
        RoundTicks rows = numbers.rows;
        each(rows, lowWorld(), highWorld(), y -> horizontal(g, rows.value(y), colors.grid()));
        vertical(g, 0, colors.axis());
        horizontal(g, 0, colors.axis());
    }

    public void paintMargins(Graphics2D g) {
        g.setColor(colors.margin());
        g.fillRect(0, 0, view.width, Rulers.top());
        g.fillRect(0, 0, Rulers.left(), view.height);
        g.setColor(colors.axis());
        g.drawLine(Rulers.left(), Rulers.top(), view.width, Rulers.top());
        g.drawLine(Rulers.left(), Rulers.top(), Rulers.left(), view.height);
        g.setFont(font);
        g.setColor(colors.ink());
        Numbers numbers = numbers(g);
        paintColumns(g, numbers);
        paintRows(g, numbers);
        g.setColor(colors.margin());
        g.fillRect(0, 0, Rulers.left(), Rulers.top());
        g.setColor(colors.ink());
        String corner = numbers.factored ? numbers.rows.factor() : "y\\x";
        paintInMargin(g, corner, baseline(g.getFontMetrics()));
    }

    /**
     * The numbers along the axes: the same steps in the same form where units are as long in x as
     * in y.
     *
     * @param factored whether without the power of ten, which then stands in the corner
     */
    private record Numbers(RoundTicks columns, RoundTicks rows, boolean factored) {}

    private Numbers numbers(Graphics2D g) {
        FontMetrics metrics = g.getFontMetrics(font);
        RoundTicks close = ticks(map.worldHeight(APART));
        if (!equal()) return new Numbers(columnsWithRoom(metrics, false), close, false);
        if (fitInFull(close, g) && !close.isLong()) {
            RoundTicks both = columnsWithRoom(metrics, false);
            return new Numbers(both, both, false);
        }
        RoundTicks both = columnsWithRoom(metrics, true);
        return shortWithoutPower(both)
                ? new Numbers(both, both, true)
                : new Numbers(columnsWithRoom(metrics, false), close, false);
    }

    private boolean equal() {
        return map.scaleX() == Math.abs(map.scaleY());
    }

    private boolean shortWithoutPower(RoundTicks ticks) {
        double farthest =
                DoubleStream.of(leftWorld(), rightWorld(), lowWorld(), highWorld())
                        .map(Math::abs)
                        .max()
                        .orElseThrow();
        return ticks.exponent() != 0 && farthest / ticks.step() * ticks.digit() < SHORT;
    }

    private String number(RoundTicks ticks, long tick, boolean factored) {
        return factored ? ticks.factored(tick) : ticks.shown(tick, locale);
    }

    private void paintColumns(Graphics2D g, Numbers numbers) {
        FontMetrics metrics = g.getFontMetrics();
        each(
                numbers.columns,
                leftWorld(),
                rightWorld(),
                tick -> {
                    String number = number(numbers.columns, tick, numbers.factored);
                    int wide = metrics.stringWidth(number);
                    double middle = map.viewX(numbers.columns.value(tick));
                    int at = (int) Math.round(middle - wide / 2.0);
                    if (at > Rulers.left() && at + wide < view.width)
                        g.drawString(number, at, baseline(metrics));
                });
    }

    /** The closest ticks whose numbers do not touch. */
    private RoundTicks columnsWithRoom(FontMetrics metrics, boolean factored) {
        double apart = APART;
        while (true) {
            RoundTicks ticks = ticks(map.worldWidth(apart));
            int widest =
                    Math.max(
                            wide(metrics, ticks, leftWorld(), factored),
                            wide(metrics, ticks, rightWorld(), factored));
            if (ticks.step() * map.scaleX() >= widest + 12 || apart > view.width) return ticks;
            apart *= 1.5;
        }
    }

    private int wide(FontMetrics metrics, RoundTicks ticks, double world, boolean factored) {
        return metrics.stringWidth(number(ticks, ticks.before(world), factored));
    }

    private void paintRows(Graphics2D g, Numbers numbers) {
        FontMetrics metrics = g.getFontMetrics();
        RoundTicks ticks = numbers.rows;
        boolean full = numbers.factored || fitInFull(ticks, g);
        each(
                ticks,
                lowWorld(),
                highWorld(),
                tick -> {
                    String number =
                            full
                                    ? number(ticks, tick, numbers.factored)
                                    : ticks.shown(tick, locale, true);
                    double middle = map.viewY(ticks.value(tick));
                    int base = (int) Math.round(middle + metrics.getAscent() / 2.0 - 1);
                    if (base - metrics.getAscent() >= Rulers.top() && base < view.height)
                        paintInMargin(g, number, base);
                });
    }

    /** Whether rows are numbered without a power of ten in a type that is large enough. */
    private boolean fitInFull(RoundTicks ticks, Graphics2D g) {
        FontMetrics smallest =
                g.getFontMetrics(font.deriveFont((float) (SMALLEST * font.getSize2D())));
        return fits(ticks.shown(ticks.before(lowWorld()) + 1, locale), smallest)
                && fits(ticks.shown(ticks.before(highWorld()), locale), smallest);
    }

    private void paintInMargin(Graphics2D g, String words, int base) {
        g.setFont(fitting(words, g));
        g.drawString(words, Rulers.left() - 6 - g.getFontMetrics().stringWidth(words), base);
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

    private void vertical(Graphics2D g, double worldX, Color color) {
        double x = Math.rint(map.viewX(worldX));
        if (!(x >= Rulers.left() && x <= view.width)) return;
        g.setColor(color);
        g.drawLine((int) x, Rulers.top(), (int) x, view.height);
    }

    private void horizontal(Graphics2D g, double worldY, Color color) {
        double y = Math.rint(map.viewY(worldY));
        if (!(y >= Rulers.top() && y <= view.height)) return;
        g.setColor(color);
        g.drawLine(Rulers.left(), (int) y, view.width, (int) y);
    }
}
