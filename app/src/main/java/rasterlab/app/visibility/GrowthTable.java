package rasterlab.app.visibility;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.language.Texts;
import rasterlab.engine.visibility.hidden.Growth.Axis;

/** The exponents by which work grows, with what each method's line looks like. */
final class GrowthTable {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 13);

    /** Units of which the type is 13 high, on both sides of the table. */
    private static final int BESIDE = 20;

    /** Length of a method's line in such units. */
    private static final int LINE = 32;

    /** The gap between a method's line and its name, in such units. */
    private static final int GAP = 6;

    /** The most from row to row, in such units. */
    private static final int MOST_ROW = 24;

    /** The most between two columns, in such units. */
    private static final int MOST_GAP = 30;

    private final GrowthChart chart;
    private final Texts texts;
    private final ChartLook paper;

    GrowthTable(GrowthChart chart, Texts texts, ChartLook paper) {
        this.chart = chart;
        this.texts = texts;
        this.paper = paper;
    }

    /** Fills a place of that size, as far as its rows are not too far from each other then. */
    void paint(Graphics2D graphics, Dimension size) {
        graphics.setFont(FONT);
        graphics.setColor(paper.ink());
        FontMetrics metrics = graphics.getFontMetrics();
        int y = metrics.getHeight();
        for (String line :
                Wrapping.lines(
                        texts.text("growth.exponents"),
                        size.width - 2 * BESIDE,
                        metrics::stringWidth)) {
            graphics.drawString(line, BESIDE, y);
            y += metrics.getHeight();
        }
        int rows = 1 + chart.methods().size();
        int row = Math.min(MOST_ROW, (size.height - y - metrics.getDescent()) / (rows - 1));
        int names = BESIDE + LINE + GAP;
        List<String> heads =
                Stream.of(Axis.values())
                        .map(axis -> texts.text("growth." + GrowthChart.code(axis) + ".short"))
                        .toList();
        int[] columns = columns(names + widest(metrics) + 2 * GAP, size.width, heads, metrics);
        row(graphics, columns, y, heads);
        for (String method : chart.methods()) {
            y += row;
            swatch(graphics, method, y - metrics.getAscent() / 3);
            graphics.drawString(method, names, y);
            row(graphics, columns, y, exponents(method));
        }
    }

    private int widest(FontMetrics metrics) {
        return chart.methods().stream().mapToInt(metrics::stringWidth).max().orElse(0);
    }

    /** Where columns begin that share the width, so far as none is too far from the one before. */
    private static int[] columns(int first, int width, List<String> heads, FontMetrics metrics) {
        int least = metrics.stringWidth("0.00");
        int[] wide =
                heads.stream()
                        .mapToInt(head -> Math.max(least, metrics.stringWidth(head)))
                        .toArray();
        int free = width - first - BESIDE - IntStream.of(wide).sum();
        int gap = Math.min(MOST_GAP, free / (heads.size() - 1));
        var begin = new int[wide.length];
        int x = first;
        for (int i = 0; i < wide.length; i++) {
            begin[i] = x;
            x += wide[i] + gap;
        }
        return begin;
    }

    private static void row(Graphics2D graphics, int[] columns, int y, List<String> cells) {
        for (int i = 0; i < columns.length; i++) graphics.drawString(cells.get(i), columns[i], y);
    }

    private List<String> exponents(String method) {
        return Stream.of(Axis.values())
                .map(axis -> chart.growth(method, axis).exponent())
                .map(each -> String.format(texts.locale(), "%.2f", each).replace('-', '−'))
                .toList();
    }

    /** Draws the method's line with its mark. */
    private void swatch(Graphics2D graphics, String method, int y) {
        MethodLook look = chart.look(method).on(paper);
        var line = (Graphics2D) graphics.create();
        line.setColor(look.color());
        line.setStroke(look.stroke());
        line.drawLine(BESIDE, y, BESIDE + LINE, y);
        look.marker().paint(line, BESIDE + LINE / 2.0, y, 9);
        line.dispose();
    }
}
