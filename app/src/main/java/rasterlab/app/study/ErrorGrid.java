package rasterlab.app.study;

import java.awt.Color;
import java.awt.Graphics2D;
import org.knowm.xchart.internal.chartpart.Annotation;

/** The horizontal lines of the error axis, one for each decade, and the place for zero error. */
final class ErrorGrid extends Annotation {
    private static final Color LINE = new Color(0, 0, 0, 40);
    private static final Color EXACT = new Color(0, 158, 115, 28);

    private final ErrorAxis axis;

    ErrorGrid(ErrorAxis axis) {
        super(false);
        this.axis = axis;
    }

    @Override
    public void paint(Graphics2D graphics) {
        int left = getXAxisScreenValueForMin();
        int right = getXAxisScreenValueForMax();
        int bottom = Math.max(getYAxisScreenValueForMin(), getYAxisScreenValueForMax());
        int border = getYAxisScreenValue(axis.border());
        graphics.setColor(EXACT);
        graphics.fillRect(left, border, right - left, bottom - border);
        graphics.setColor(LINE);
        for (int decade = axis.low(); decade < axis.high(); decade++) {
            int y = getYAxisScreenValue(Math.pow(10, decade));
            graphics.drawLine(left, y, right, y);
        }
    }
}
