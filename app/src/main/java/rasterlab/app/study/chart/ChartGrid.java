package rasterlab.app.study.chart;

import java.awt.Color;
import java.awt.Graphics2D;
import org.knowm.xchart.internal.chartpart.Annotation;

/** A line through the chart at each number of its axes, and the band for zero error. */
final class ChartGrid extends Annotation {
    private static final Color EXACT = new Color(0, 158, 115, 28);

    private final CostAxis costs;
    private final ErrorAxis errors;
    private final Color line;

    /**
     * @param ink of the words on the chart, of which the lines have a little
     */
    ChartGrid(CostAxis costs, ErrorAxis errors, Color ink) {
        super(false);
        this.costs = costs;
        this.errors = errors;
        line = new Color(ink.getRed(), ink.getGreen(), ink.getBlue(), 40);
    }

    @Override
    public void paint(Graphics2D graphics) {
        int left = getXAxisScreenValue(costs.left());
        int right = getXAxisScreenValue(costs.right());
        int bottom = getYAxisScreenValue(errors.bottom());
        int top = getYAxisScreenValue(errors.top());
        int border = getYAxisScreenValue(errors.border());
        graphics.setColor(EXACT);
        graphics.fillRect(left, border, right - left, bottom - border);
        graphics.setColor(line);
        for (double tick : errors.ticks()) {
            int y = getYAxisScreenValue(tick);
            graphics.drawLine(left, y, right, y);
        }
        for (double tick : costs.ticks()) {
            int x = getXAxisScreenValue(tick);
            graphics.drawLine(x, top, x, bottom);
        }
    }
}
