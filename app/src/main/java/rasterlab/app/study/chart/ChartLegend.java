package rasterlab.app.study;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import rasterlab.app.chart.MethodLook;

/**
 * The methods of a chart in columns below it: beside it, in a narrow stage, their names would take
 * more width than the plot.
 */
final class ChartLegend {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);
    private static final int ROW = 17;
    private static final int MARGIN = 10;

    /** A piece of the method's line with its mark in the middle. */
    private static final int SAMPLE = 26;

    private static final int MARK = 9;
    private static final int BEFORE_NAME = 6;
    private static final int BETWEEN_COLUMNS = 16;

    private final List<Map.Entry<String, MethodLook>> methods;
    private final Color ink;
    private final int width;
    private final FontMetrics metrics;
    private final int rows;

    /**
     * @param looks of the methods, in the order in which they are read down each column
     * @param ink of their names
     * @param width of the chart, in its own units
     * @param graphics on which it is painted
     */
    ChartLegend(Map<String, MethodLook> looks, Color ink, int width, Graphics2D graphics) {
        methods = List.copyOf(looks.entrySet());
        this.ink = ink;
        this.width = width;
        metrics = graphics.getFontMetrics(FONT);
        rows =
                IntStream.rangeClosed(1, methods.size())
                        .filter(high -> across(high) <= width - 2 * MARGIN)
                        .findFirst()
                        .orElse(methods.size());
    }

    /** Width of all columns where they are so many methods high. */
    private int across(int high) {
        return starts(high).map(first -> column(first, high)).sum() - BETWEEN_COLUMNS;
    }

    /** The number of each column's first method. */
    private IntStream starts(int high) {
        return IntStream.iterate(0, first -> first < methods.size(), first -> first + high);
    }

    /** Width of a column with the gap behind it. */
    private int column(int first, int high) {
        int longest =
                methods.stream()
                        .skip(first)
                        .limit(high)
                        .mapToInt(method -> metrics.stringWidth(method.getKey()))
                        .max()
                        .orElse(0);
        return SAMPLE + BEFORE_NAME + longest + BETWEEN_COLUMNS;
    }

    int height() {
        return rows * ROW + MARGIN;
    }

    /**
     * @param top upper edge of the legend, in the chart's units
     */
    void paint(Graphics2D graphics, int top) {
        graphics.setRenderingHint(
                RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        graphics.setFont(FONT);
        int left = Math.max(MARGIN, (width - across(rows)) / 2);
        for (int first : starts(rows).toArray()) {
            for (int i = first; i < Math.min(first + rows, methods.size()); i++)
                paint(graphics, methods.get(i), left, top + (i - first) * ROW + ROW / 2);
            left += column(first, rows);
        }
    }

    private void paint(
            Graphics2D graphics, Map.Entry<String, MethodLook> method, int left, int middle) {
        MethodLook look = method.getValue();
        graphics.setColor(look.colour());
        graphics.setStroke(look.stroke());
        graphics.drawLine(left, middle, left + SAMPLE, middle);
        look.marker().paint(graphics, left + SAMPLE / 2.0, middle, MARK);
        graphics.setColor(ink);
        int baseline = middle + (metrics.getAscent() - metrics.getDescent()) / 2;
        graphics.drawString(method.getKey(), left + SAMPLE + BEFORE_NAME, baseline);
    }
}
