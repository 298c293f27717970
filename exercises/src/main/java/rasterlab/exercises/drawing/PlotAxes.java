package rasterlab.exercises.drawing;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.font.FontRenderContext;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.stream.Stream;
import rasterlab.exercises.drawing.AxisTicks.AxisTick;

/** Draws the plot's border, a pale grid, and the labels of both axes around it. */
final class PlotAxes {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private static final Font NAME = new Font(Font.SERIF, Font.ITALIC, 15);
    private static final Font TAG = new Font(Font.SANS_SERIF, Font.BOLD, 13);
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);
    private static final Color ZERO = new Color(0xA9B1BB);

    private static final int SPACE = 6;
    private static final int LINE = 16;
    private static final int NARROWEST_LEFT = 34;

    /** Pixels between ticks, at least: labels of x stand beside each other. */
    private static final int X_DISTANCE = 85;

    private static final int Y_DISTANCE = 55;
    private static final int FEWEST = 3;

    private final String language;
    private final AxisTicks x;
    private final AxisTicks y;
    private final PlaneToPixels view;
    private final int width;
    private final int height;

    /**
     * @param up whether y grows upwards
     * @param language in which numbers are written, such as "ru"
     */
    PlotAxes(PlaneBox box, boolean up, String language) {
        this.language = language;
        y = AxisTicks.of(box.y(), Math.max(FEWEST, PlaneToPixels.height(box) / Y_DISTANCE));
        int left = NARROWEST_LEFT;
        for (AxisTick tick : y.ticks())
            left = Math.max(left, (int) Math.ceil(width(text(tick.label()))) + 2 * SPACE);
        int top = SPACE + LINE + (y.note().isEmpty() ? 0 : LINE / 2);
        view = new PlaneToPixels(box, up, left, top);
        Rectangle2D plot = view.plot();
        x = AxisTicks.of(box.x(), Math.max(FEWEST, (int) plot.getWidth() / X_DISTANCE));
        String last = x.ticks().isEmpty() ? "" : x.ticks().get(x.ticks().size() - 1).label();
        double noted = left + width(text(y.note())) + 3 * SPACE;
        width =
                (int)
                        Math.ceil(
                                Math.max(
                                        plot.getMaxX()
                                                + Math.max(width(text(last)) / 2, LINE)
                                                + SPACE,
                                        noted));
        height = (int) plot.getMaxY() + SPACE + LINE + SPACE + (x.note().isEmpty() ? 0 : LINE);
    }

    PlaneToPixels view() {
        return view;
    }

    /** The picture's width in pixels. */
    int width() {
        return width;
    }

    /** The picture's height in pixels. */
    int height() {
        return height;
    }

    void paint(Graphics2D g) {
        Rectangle2D plot = view.plot();
        g.setStroke(new BasicStroke(1));
        for (AxisTick tick : x.ticks()) {
            double place = view.x(tick.value());
            g.setColor(tick.value() == 0 ? ZERO : Ink.GRID);
            g.draw(new Line2D.Double(place, plot.getMinY(), place, plot.getMaxY() + 4));
        }
        for (AxisTick tick : y.ticks()) {
            double place = view.y(tick.value());
            g.setColor(tick.value() == 0 ? ZERO : Ink.GRID);
            g.draw(new Line2D.Double(plot.getMinX() - 4, place, plot.getMaxX(), place));
        }
        g.setColor(ZERO);
        g.draw(plot);
        label(g, plot);
    }

    /**
     * Writes a note above the plot, at its right end.
     *
     * @param after another note that stands to the right of it, or nothing
     */
    void tag(Graphics2D g, String note, String after, Color color) {
        Rectangle2D plot = view.plot();
        double right = plot.getMaxX() - (after.isEmpty() ? 0 : width(after, TAG) + 2 * SPACE);
        g.setColor(color);
        g.setFont(TAG);
        write(g, note, right - width(note, TAG), plot.getMinY() - SPACE);
    }

    private void label(Graphics2D g, Rectangle2D plot) {
        double below = plot.getMaxY() + LINE;
        g.setColor(Ink.LABEL);
        g.setFont(FONT);
        for (AxisTick tick : x.ticks())
            write(
                    g,
                    text(tick.label()),
                    view.x(tick.value()) - width(text(tick.label())) / 2,
                    below);
        for (AxisTick tick : y.ticks())
            write(
                    g,
                    text(tick.label()),
                    plot.getMinX() - SPACE - width(text(tick.label())),
                    view.y(tick.value()) + 4);
        write(g, text(x.note()), plot.getMaxX() - width(text(x.note())), below + LINE);
        double above = plot.getMinY() - SPACE;
        write(g, text(y.note()), plot.getMinX() + (view.isUp() ? SPACE : 0), above);
        g.setFont(NAME);
        write(g, "x", plot.getMaxX() + SPACE, plot.getMaxY() - 2);
        write(
                g,
                "y",
                view.isUp() ? plot.getMinX() - 2 * SPACE : SPACE,
                view.isUp() ? above : below);
    }

    /** Whether a number beside them is written otherwise in another language. */
    boolean hasFractions() {
        return Stream.of(x, y)
                .flatMap(
                        axis ->
                                Stream.concat(
                                        Stream.of(axis.note()),
                                        axis.ticks().stream().map(AxisTick::label)))
                .anyMatch(NumberText::hasFraction);
    }

    private String text(String number) {
        return NumberText.inPicture(number, language);
    }

    private static void write(Graphics2D g, String text, double left, double baseline) {
        g.drawString(text, (float) left, (float) baseline);
    }

    private static double width(String text) {
        return width(text, FONT);
    }

    private static double width(String text, Font font) {
        return text.isEmpty() ? 0 : font.getStringBounds(text, CONTEXT).getWidth();
    }
}
