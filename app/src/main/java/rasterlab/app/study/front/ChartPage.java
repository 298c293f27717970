package rasterlab.app.study.front;

import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.LeaderColumn;

/**
 * The page of a chart: its title above the plot, names to the right of it, notes below.
 *
 * @param top where the plot begins
 * @param names of all that the plot shows
 */
record ChartPage(
        ChartLook paper, Locale locale, int top, String title, List<String> names, String note) {
    private static final int LEFT = 92;
    private static final int AXIS = 46;

    /**
     * Paints the page in that size.
     *
     * @param inside paints the plot; left out where there is nothing to name
     */
    void paint(
            Graphics2D graphics,
            double width,
            double height,
            BiConsumer<PlotFrame, Rectangle2D> inside) {
        List<String> notes = PlotFrame.noteLines(note, width - 24, graphics);
        int column = LeaderColumn.width(names, graphics.getFontMetrics(LeaderColumn.FONT));
        double right = Math.max(width * 0.4, width - column - 40);
        double bottom = height - AXIS - PlotFrame.noteHeight(notes) - 6;
        var plot = new Rectangle2D.Double(LEFT, top, right - LEFT, bottom - top);
        var frame = new PlotFrame(graphics, paper, plot, locale);
        frame.title(title, width);
        if (!names.isEmpty()) inside.accept(frame, plot);
        frame.border();
        frame.note(notes, 12, height - PlotFrame.noteHeight(notes) - 4);
    }
}
