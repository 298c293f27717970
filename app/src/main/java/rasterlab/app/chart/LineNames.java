package rasterlab.app.study.chart;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.app.chart.LeaderColumn;

/** Names of lines in a column to the right of a chart, each with a line to its line's end. */
final class LineNames extends Annotation {
    /** Width that the column takes beside its names. */
    static final int MARGIN = 34;

    /** Distance of the column from the plot. */
    private static final int GAP = 24;

    private static final double MARK = 8;

    private record Name(String text, SizeLabels.SizePoint at, Color color) {}

    private final Color ink;
    private final List<Name> names = new ArrayList<>();

    /**
     * @param ink of the names
     */
    LineNames(Color ink) {
        super(false);
        this.ink = ink;
    }

    /**
     * Adds a name.
     *
     * @param at end of its line
     * @param color of the line
     */
    void add(String text, SizeLabels.SizePoint at, Color color) {
        names.add(new Name(text, at, color));
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
                                                getXAxisScreenValue(one.at().cost()),
                                                getYAxisScreenValue(one.at().position()),
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
