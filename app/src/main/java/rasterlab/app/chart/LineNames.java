package rasterlab.app.chart;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import org.knowm.xchart.internal.chartpart.Annotation;

/** Names of lines in a column to the right of a chart, each with a line to its line's end. */
public final class LineNames extends Annotation {
    /** Width that the column takes beside its names. */
    private static final int MARGIN = 34;

    /** Distance of the column from the plot. */
    private static final int GAP = 24;

    private static final double MARK = 8;

    private record Name(String text, double x, double y, Color color) {}

    private final Color ink;
    private final List<Name> names = new ArrayList<>();

    /**
     * @param ink of the names
     */
    public LineNames(Color ink) {
        super(false);
        this.ink = ink;
    }

    /** The width that a column of those names takes beside a chart. */
    public static int width(List<String> names, Graphics2D graphics) {
        return LeaderColumn.width(names, graphics.getFontMetrics(LeaderColumn.FONT)) + MARGIN;
    }

    /**
     * Adds a name.
     *
     * @param x of its line's end, on the chart's axis to the right
     * @param y of its line's end, on the axis upwards
     * @param color of the line
     */
    public void add(String text, double x, double y, Color color) {
        names.add(new Name(text, x, y, color));
    }

    @Override
    public void paint(Graphics2D graphics) {
        int low = getYAxisScreenValueForMin();
        int high = getYAxisScreenValueForMax();
        List<LeaderColumn.LeaderLabel> labels =
                names.stream()
                        .map(
                                one ->
                                        new LeaderColumn.LeaderLabel(
                                                one.text(),
                                                getXAxisScreenValue(one.x()),
                                                getYAxisScreenValue(one.y()),
                                                ink,
                                                one.color()))
                        .toList();
        new LeaderColumn(
                        labels,
                        getXAxisScreenValueForMax() + (double) GAP,
                        Math.min(low, high),
                        Math.max(low, high))
                .paint(graphics, MARK);
    }
}
