package rasterlab.app.chart;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Names in a column beside a plot, each with a line to its point, of which no two cross.
 *
 * <p>Two lines that crossed would be longer than if they changed their ends, so ends are changed
 * while that makes two of them shorter. Source: M. A. Bekos and others, Boundary Labeling,
 * Computational Geometry 36(3), 2007, section 3.
 */
public final class LeaderColumn {
    public static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    private static final int ROW = 16;
    private static final double SHORT = 1e-9;

    /**
     * A name and where the line to it begins.
     *
     * @param color of the words
     * @param leader of the line
     */
    public record LeaderLabel(String text, double x, double y, Color color, Color leader) {}

    /** Where a label stands: left end and middle of its row. */
    record LabelRow(double x, double y) {}

    private final List<LeaderLabel> labels;
    private final double left;
    private final double top;
    private final double bottom;

    /**
     * @param left edge of the column
     * @param top upper end of the column
     * @param bottom lower end of the column
     */
    public LeaderColumn(List<LeaderLabel> labels, double left, double top, double bottom) {
        this.labels = labels.stream().sorted(Comparator.comparingDouble(LeaderLabel::y)).toList();
        this.left = left;
        this.top = top;
        this.bottom = bottom;
    }

    /** Width of the widest of these names. */
    public static int width(List<String> names, FontMetrics metrics) {
        return names.stream().mapToInt(metrics::stringWidth).max().orElse(0);
    }

    /** The rows of the labels, in their order. */
    List<LabelRow> rows() {
        double[] ys = spread();
        Integer[] row = IntStream.range(0, ys.length).boxed().toArray(Integer[]::new);
        boolean better = true;
        while (better) {
            better = false;
            for (int i = 0; i < row.length; i++)
                for (int j = 0; j < i; j++)
                    if (length(i, ys[row[j]]) + length(j, ys[row[i]])
                            < length(i, ys[row[i]]) + length(j, ys[row[j]]) - SHORT) {
                        Integer kept = row[i];
                        row[i] = row[j];
                        row[j] = kept;
                        better = true;
                    }
        }
        var rows = new ArrayList<LabelRow>();
        for (Integer one : row) rows.add(new LabelRow(left, ys[one]));
        return rows;
    }

    private double length(int label, double y) {
        return Math.hypot(left - labels.get(label).x(), y - labels.get(label).y());
    }

    /** Heights as near to the points' own as rows allow that do not overlap. */
    private double[] spread() {
        double[] ys = labels.stream().mapToDouble(LeaderLabel::y).toArray();
        double row = Math.min(ROW, (bottom - top) / Math.max(1, ys.length));
        double least = top + row / 2;
        for (int i = 0; i < ys.length; i++) {
            ys[i] = Math.max(ys[i], least);
            least = ys[i] + row;
        }
        double most = bottom - row / 2;
        for (int i = ys.length - 1; i >= 0; i--) {
            ys[i] = Math.min(ys[i], most);
            most = ys[i] - row;
        }
        return ys;
    }

    /**
     * Draws the names and the lines to them.
     *
     * @param gap from a point's middle to where the line begins
     */
    public void paint(Graphics2D graphics, double gap) {
        graphics.setFont(FONT);
        FontMetrics metrics = graphics.getFontMetrics();
        List<LabelRow> rows = rows();
        graphics.setStroke(new BasicStroke(0.8f));
        for (int i = 0; i < rows.size(); i++) {
            LeaderLabel label = labels.get(i);
            LabelRow row = rows.get(i);
            double end = row.x() - 4;
            double length = Math.hypot(end - label.x(), row.y() - label.y());
            double share = length > gap ? gap / length : 1;
            graphics.setColor(label.leader());
            graphics.draw(
                    new Line2D.Double(
                            label.x() + share * (end - label.x()),
                            label.y() + share * (row.y() - label.y()),
                            end,
                            row.y()));
            graphics.setColor(label.color());
            float baseline = (float) (row.y() + (metrics.getAscent() - metrics.getDescent()) / 2.0);
            graphics.drawString(label.text(), (float) row.x(), baseline);
        }
    }
}
