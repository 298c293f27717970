package rasterlab.app.coordinates.turn;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import javax.accessibility.AccessibleRole;
import javax.swing.BorderFactory;
import javax.swing.UIManager;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.coordinates.figure.FigureColors;
import rasterlab.app.language.Texts;

/** Each method's error over the number of turns, both in powers of ten. */
final class DriftChart extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    /** The decades of the error: no error, or less, is drawn at the lower edge. */
    private static final int LOWEST = -18;

    private static final int HIGHEST = 1;
    private static final int DECADES_OF_ERROR = HIGHEST - LOWEST;
    private static final int DECADES = (int) Math.round(Math.log10(TurnScene.CHARTED));
    private static final int BESIDE = 10;
    private static final int LEAD = 18;
    private static final int BEHIND = 12;

    /** View units between and beside the words and the curves. */
    private static final int ROOM_AROUND = 2 * BESIDE + LEAD + BEHIND;

    /** The least width of the curves, in widths of a letter. */
    private static final int LETTERS = 6;

    /** View units of type that is not made smaller. */
    private static final float LEAST_TYPE = 14;

    private static final double DOT = 3;

    private final transient Texts texts;
    private transient List<TurnScene.Drift> drifts = List.of();
    private String chosen = "";
    private boolean busy;

    DriftChart(Texts texts) {
        super(AccessibleRole.CANVAS);
        this.texts = texts;
        setName("stage.chart");
        getAccessibleContext().setAccessibleName(texts.text("stage.chart"));
        setBorder(BorderFactory.createLineBorder(UIManager.getColor("Component.borderColor")));
    }

    /**
     * @param turning whether newer drifts are on their way
     */
    void show(TurnScene scene, boolean turning) {
        drifts = scene.drifts().stream().filter(each -> !each.refused()).toList();
        chosen = scene.choice().method();
        busy = turning;
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(360, 360);
    }

    /** The size in which the names do not lie over the curves, nor over each other. */
    @Override
    public Dimension getMinimumSize() {
        FontMetrics metrics = getFontMetrics(usual());
        int width = wordsWidth(usual()) + ROOM_AROUND + LETTERS * metrics.charWidth('m');
        return new Dimension(width, metrics.getHeight() * (drifts.size() + 4));
    }

    private static Font usual() {
        return UIManager.getFont("Label.font");
    }

    /** The usual one, or as much smaller as leaves half of the width to the curves. */
    private Font font() {
        float size = usual().getSize2D();
        float fitting = size * (getWidth() / 2f - ROOM_AROUND) / wordsWidth(usual());
        return usual().deriveFont(Math.min(size, Math.max(LEAST_TYPE, fitting)));
    }

    /** Width of the words on both sides of the curves. */
    private int wordsWidth(Font font) {
        return numbersWidth(font) + namesWidth(font);
    }

    private int numbersWidth(Font font) {
        return getFontMetrics(font).stringWidth(power(LOWEST));
    }

    /** Width of the longest of the methods' names. */
    private int namesWidth(Font font) {
        FontMetrics metrics = getFontMetrics(font.deriveFont(Font.BOLD));
        return drifts.stream().mapToInt(each -> metrics.stringWidth(called(each))).max().orElse(0);
    }

    private String called(TurnScene.Drift drift) {
        return OwnWords.called(drift.method(), texts.language());
    }

    /**
     * Where the curves lie, in view units.
     *
     * @param font of the words, bold of the title and of the chosen method's name
     * @param title the title's lines
     * @param left of no power of ten of turns
     * @param right of the last one
     * @param top of the highest error
     * @param bottom of the lowest
     */
    private record Plot(
            Font font, List<String> title, double left, double right, double top, double bottom) {
        double x(double decade) {
            return left + (right - left) * decade / DECADES;
        }

        double y(double decade) {
            return top + (bottom - top) * (HIGHEST - decade) / DECADES_OF_ERROR;
        }

        /** View y of a curve's last point. */
        double end(TurnScene.Drift drift) {
            return y(decade(drift.samples().get(drift.samples().size() - 1).error()));
        }
    }

    private Plot plot() {
        Font font = font();
        int line = getFontMetrics(font).getHeight();
        List<String> title = title(font);
        return new Plot(
                font,
                title,
                numbersWidth(font) + 2.0 * BESIDE,
                getWidth() - (double) namesWidth(font) - LEAD - BEHIND,
                line * title.size() + 20.0,
                getHeight() - 2.0 * line - 18);
    }

    private List<String> title(Font font) {
        FontMetrics bold = getFontMetrics(font.deriveFont(Font.BOLD));
        return Wrapping.lines(
                texts.text(busy ? "busy" : "chart.error"),
                Math.max(1, getWidth() - 2 * BESIDE),
                bold::stringWidth);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        draw(g);
        g.dispose();
    }

    /** Draws the chart, in view units. */
    void draw(Graphics2D g) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        Plot plot = plot();
        g.setFont(plot.font);
        StageColors colors = StageColors.now();
        g.setColor(colors.ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        paintGrid(g, plot, colors);
        drifts.forEach(each -> paintCurve(g, plot, each, colors));
        paintNames(g, plot, colors);
    }

    private void paintGrid(Graphics2D g, Plot plot, StageColors colors) {
        FontMetrics metrics = g.getFontMetrics();
        int every = 2;
        while (plot.y(0) - plot.y(every) < metrics.getAscent() && every < DECADES_OF_ERROR)
            every += 2;
        for (int decade = HIGHEST - 1; decade > LOWEST; decade -= every)
            if (plot.y(LOWEST) - plot.y(decade) >= metrics.getAscent())
                paintLevel(g, plot, decade, power(decade), colors);
        paintLevel(g, plot, LOWEST, "0", colors);
        every = 1;
        while (plot.x(every) - plot.x(0) < metrics.stringWidth(power(DECADES)) + 6
                && every < DECADES) every++;
        for (int decade = 0; decade <= DECADES; decade++) {
            g.setColor(colors.grid());
            g.draw(
                    new Line2D.Double(
                            plot.x(decade), plot.y(LOWEST), plot.x(decade), plot.y(HIGHEST)));
            g.setColor(colors.ink());
            if (decade % every == 0)
                centered(
                        g,
                        power(decade),
                        plot.x(decade),
                        plot.y(LOWEST) + 4.0 + metrics.getAscent());
        }
        g.setColor(colors.ink());
        centered(
                g,
                texts.text("chart.turns"),
                (plot.x(0) + plot.x(DECADES)) / 2,
                getHeight() - 10.0);
        g.setFont(g.getFont().deriveFont(Font.BOLD));
        int base = 8 + metrics.getAscent();
        for (String line : plot.title) {
            g.drawString(line, BESIDE, base);
            base += metrics.getHeight();
        }
        g.setFont(g.getFont().deriveFont(Font.PLAIN));
    }

    private static void paintLevel(
            Graphics2D g, Plot plot, int decade, String said, StageColors colors) {
        g.setColor(colors.grid());
        g.draw(new Line2D.Double(plot.x(0), plot.y(decade), plot.x(DECADES), plot.y(decade)));
        g.setColor(colors.ink());
        float left = (float) (plot.x(0) - BESIDE - g.getFontMetrics().stringWidth(said));
        g.drawString(said, left, (float) plot.y(decade) + 4);
    }

    private static void centered(Graphics2D g, String said, double x, double y) {
        double left = x - g.getFontMetrics().stringWidth(said) / 2.0;
        g.drawString(said, (float) Math.max(BESIDE, left), (float) y);
    }

    private void paintCurve(Graphics2D g, Plot plot, TurnScene.Drift drift, StageColors colors) {
        g.setColor(color(drift, colors));
        g.setStroke(new BasicStroke(drift.method().equals(chosen) ? 3.2f : 1.8f));
        double beforeX = Double.NaN;
        double beforeY = Double.NaN;
        for (TurnScene.DriftSample sample : drift.samples()) {
            double x = plot.x(Math.log10(sample.times()));
            double y = plot.y(decade(sample.error()));
            if (!Double.isNaN(beforeX)) g.draw(new Line2D.Double(beforeX, beforeY, x, y));
            g.fill(new Ellipse2D.Double(x - DOT, y - DOT, 2 * DOT, 2 * DOT));
            beforeX = x;
            beforeY = y;
        }
    }

    private static Color color(TurnScene.Drift drift, StageColors colors) {
        return MethodColors.edgeOn(colors.ground(), FigureColors.OWN.of(drift.method()));
    }

    private static double decade(double error) {
        return error > 0 ? Math.max(LOWEST, Math.min(HIGHEST, Math.log10(error))) : LOWEST;
    }

    /** Paints the names beside the curves' ends, from below, none over another. */
    private void paintNames(Graphics2D g, Plot plot, StageColors colors) {
        var sorted = new ArrayList<>(drifts);
        sorted.sort(Comparator.comparingDouble(plot::end).reversed());
        double[] places = places(sorted, plot, g.getFontMetrics().getHeight());
        for (int i = 0; i < sorted.size(); i++) {
            TurnScene.Drift each = sorted.get(i);
            double y = places[i];
            g.setColor(color(each, colors));
            g.setStroke(new BasicStroke(1.4f));
            g.draw(new Line2D.Double(plot.x(DECADES), plot.end(each), plot.x(DECADES) + LEAD, y));
            g.setColor(colors.ink());
            boolean own = each.method().equals(chosen);
            g.setFont(g.getFont().deriveFont(own ? Font.BOLD : Font.PLAIN));
            g.drawString(called(each), (float) plot.x(DECADES) + LEAD + 5, (float) y + 4);
        }
    }

    /**
     * View y of names at the ends of their curves, or as near as the others let them.
     *
     * @param sorted from below
     * @param apart view units from name to name
     */
    private static double[] places(List<TurnScene.Drift> sorted, Plot plot, double apart) {
        var places = new double[sorted.size()];
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < places.length; i++) {
            places[i] = Math.min(plot.end(sorted.get(i)), lowest);
            lowest = places[i] - apart;
        }
        double highest = plot.top;
        for (int i = places.length - 1; i >= 0; i--) {
            places[i] = Math.max(places[i], highest);
            highest = places[i] + apart;
        }
        return places;
    }

    private static String power(int decade) {
        var raised = new StringBuilder("10");
        for (char each : String.valueOf(decade).toCharArray())
            raised.append(each == '-' ? '⁻' : "⁰¹²³⁴⁵⁶⁷⁸⁹".charAt(each - '0'));
        return raised.toString();
    }
}
