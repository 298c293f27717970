package rasterlab.exercises.drawing;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.List;
import rasterlab.engine.raster.PixelMark;
import rasterlab.exercises.drawing.TableComparison.CellState;

/** Draws the shown part of a table; all three pictures of a comparison on sheets of one size. */
final class TableSheet {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
    private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

    private static final int ROW_HEIGHT = 26;
    private static final int MARGIN = 6;
    private static final int PADDING = 8;

    /** Width of the place for a sign before a number. */
    private static final int SIGN = 18;

    private static final int BASELINE = 18;
    private static final int LONGEST_LABEL = 12;
    private static final String GAP = "…";
    private static final String EMPTY = "∅";

    /** Hands over the text of a cell. */
    interface Cells {
        String text(int row, int column);
    }

    private final TableComparison table;
    private final TableLabels labels;
    private final List<Integer> rows;
    private final List<Integer> columns;
    private final String language;
    private final int labelWidth;

    /** The left edge of each shown column, and the right edge of the last. */
    private final int[] edges;

    /**
     * @param rows the places of those that are shown
     * @param columns the places of those that are shown
     * @param language in which numbers are written, such as "ru"
     */
    TableSheet(
            TableComparison table,
            TableLabels labels,
            List<Integer> rows,
            List<Integer> columns,
            String language) {
        this.table = table;
        this.labels = labels;
        this.rows = rows;
        this.columns = columns;
        this.language = language;
        int widest = 0;
        for (int row : rows) widest = Math.max(widest, width(label(row, true)));
        labelWidth = widest;
        edges = new int[columns.size() + 1];
        edges[0] = MARGIN + labelWidth + PADDING;
        for (int i = 0; i < columns.size(); i++) edges[i + 1] = edges[i] + columnWidth(i);
    }

    /** The width in pixels. */
    int width() {
        return Math.max(edges[columns.size()], MARGIN + ROW_HEIGHT) + MARGIN;
    }

    /** Whether a number on it is written otherwise in another language. */
    boolean hasFractions() {
        for (int row : rows)
            for (int column : columns)
                if (row != ShownRange.GAP
                        && column != ShownRange.GAP
                        && NumberText.hasFraction(
                                table.expected(row, column)
                                        + table.actual(row, column)
                                        + table.difference(row, column))) return true;
        return false;
    }

    /** This part with numbers as that language writes them. */
    TableSheet in(String other) {
        return new TableSheet(table, labels, rows, columns, other);
    }

    /** The height in pixels. */
    int height() {
        return 2 * MARGIN + ROW_HEIGHT * (Math.max(1, rows.size()) + 1);
    }

    /**
     * The left upper corner and the size of a cell on the sheet.
     *
     * @param row place among the shown rows, from 0
     * @param column place among the shown columns, from 0
     */
    Rectangle2D cell(int row, int column) {
        return new Rectangle2D.Double(
                edges[column],
                MARGIN + (double) ROW_HEIGHT * (row + 1),
                edges[column + 1] - edges[column],
                ROW_HEIGHT);
    }

    /** The table with its numbers in one colour. */
    BufferedImage numbers(Cells cells, Color color) {
        return draw(g -> each((row, column) -> number(g, row, column, cells, color)));
    }

    /** The differences, wrong cells in a frame with a sign, all others pale. */
    BufferedImage difference() {
        return draw(g -> each((row, column) -> difference(g, row, column)));
    }

    private interface Place {
        void at(int row, int column);
    }

    private interface Painting {
        void on(Graphics2D g);
    }

    private BufferedImage draw(Painting cells) {
        var image = new BufferedImage(width(), height(), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        g.setFont(FONT);
        g.setColor(Ink.PAPER);
        g.fillRect(0, 0, image.getWidth(), image.getHeight());
        frame(g);
        cells.on(g);
        g.dispose();
        return image;
    }

    /** Draws the labels and the lines between rows. */
    private void frame(Graphics2D g) {
        g.setColor(Ink.LABEL);
        if (rows.isEmpty() || columns.isEmpty()) {
            g.drawString(EMPTY, MARGIN, MARGIN + BASELINE);
            return;
        }
        for (int i = 0; i < columns.size(); i++)
            right(g, label(columns.get(i), false), edges[i + 1] - PADDING, MARGIN);
        for (int i = 0; i < rows.size(); i++)
            right(g, label(rows.get(i), true), MARGIN + labelWidth, top(i));
        g.setColor(Ink.GRID);
        for (int i = 0; i <= rows.size(); i++)
            g.drawLine(MARGIN, top(i), edges[columns.size()], top(i));
        g.drawLine(edges[0], MARGIN, edges[0], top(rows.size()));
    }

    private void number(Graphics2D g, int row, int column, Cells cells, Color color) {
        g.setColor(isGap(row, column) ? Ink.LABEL : color);
        right(g, text(row, column, cells), edges[column + 1] - PADDING, top(row));
    }

    private void difference(Graphics2D g, int row, int column) {
        CellState state =
                isGap(row, column)
                        ? CellState.ABSENT
                        : table.state(rows.get(row), columns.get(column));
        number(g, row, column, table::difference, state.isWrong() ? Ink.EXPECTED : Ink.LABEL);
        if (!state.isWrong()) return;
        Rectangle2D cell = cell(row, column);
        double side = ROW_HEIGHT - 10.0;
        double left = cell.getX() + 5;
        double top = cell.getY() + 5;
        if (state == CellState.MISSING) PixelMark.MISSING.paint(g, left, top, side);
        if (state == CellState.EXTRA) PixelMark.EXTRA.paint(g, left, top, side);
        g.setColor(PixelMark.COLOR);
        g.setStroke(new BasicStroke(2));
        if (state == CellState.WRONG) unequal(g, left, top, side);
        g.draw(
                new Rectangle2D.Double(
                        cell.getX() + 2, cell.getY() + 2, cell.getWidth() - 4, ROW_HEIGHT - 4.0));
    }

    /** Draws the sign ≠ as lines, for not every font has it. */
    private static void unequal(Graphics2D g, double left, double top, double side) {
        for (double y : new double[] {0.36, 0.64})
            g.draw(
                    new Line2D.Double(
                            left + 0.2 * side, top + y * side, left + 0.8 * side, top + y * side));
        g.draw(
                new Line2D.Double(
                        left + 0.3 * side, top + 0.9 * side, left + 0.7 * side, top + 0.1 * side));
    }

    private void each(Place place) {
        for (int row = 0; row < rows.size(); row++)
            for (int column = 0; column < columns.size(); column++) place.at(row, column);
    }

    private int columnWidth(int column) {
        int widest = width(label(columns.get(column), false));
        for (int row = 0; row < rows.size(); row++) {
            widest = Math.max(widest, width(text(row, column, table::expected)));
            widest = Math.max(widest, width(text(row, column, table::actual)));
            widest = Math.max(widest, width(text(row, column, table::difference)));
        }
        boolean gap = columns.get(column) == ShownRange.GAP;
        return widest + 2 * PADDING + (gap ? 0 : SIGN);
    }

    private String text(int row, int column, Cells cells) {
        return isGap(row, column)
                ? GAP
                : NumberText.inPicture(cells.text(rows.get(row), columns.get(column)), language);
    }

    private boolean isGap(int row, int column) {
        return rows.get(row) == ShownRange.GAP || columns.get(column) == ShownRange.GAP;
    }

    private String label(int index, boolean row) {
        if (index == ShownRange.GAP) return GAP;
        String label = NumberText.inPicture(row ? labels.row(index) : labels.column(index));
        return label.length() <= LONGEST_LABEL ? label : label.substring(0, LONGEST_LABEL) + GAP;
    }

    private int top(int row) {
        return MARGIN + ROW_HEIGHT * (row + 1);
    }

    private static void right(Graphics2D g, String text, int right, int top) {
        g.drawString(
                text,
                (float) (right - FONT.getStringBounds(text, CONTEXT).getWidth()),
                (float) top + BASELINE);
    }

    private static int width(String text) {
        return (int) Math.ceil(FONT.getStringBounds(text, CONTEXT).getWidth());
    }
}
