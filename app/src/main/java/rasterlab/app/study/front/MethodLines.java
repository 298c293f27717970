package rasterlab.app.study.front;

import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.chart.LeaderColumn;
import rasterlab.app.chart.MethodLook;
import rasterlab.app.rooms.LabRooms;

/** Draws the points of each method in its look, with a line through them and a name at its end. */
record MethodLines(Map<String, MethodLook> looks, ChartLook paper) {
    private static final int MARK = 9;

    /** The looks of a topic's methods on that paper. */
    static Map<String, MethodLook> looks(String topic, List<String> methods, ChartLook paper) {
        var looks = new LinkedHashMap<>(MethodLook.of(methods, LabRooms.card(topic).colors()));
        looks.replaceAll((method, look) -> look.on(paper));
        return looks;
    }

    /**
     * Draws one method.
     *
     * @param places of its points, from the left
     * @return the label at the line's end
     */
    LeaderColumn.LeaderLabel draw(
            Graphics2D graphics, String method, String name, List<Point2D> places) {
        MethodLook look = looks.get(method);
        graphics.setColor(look.color());
        graphics.setStroke(look.stroke());
        for (int i = 1; i < places.size(); i++)
            graphics.draw(new Line2D.Double(places.get(i - 1), places.get(i)));
        for (Point2D at : places) look.marker().paint(graphics, at.getX(), at.getY(), MARK);
        Point2D last = places.get(places.size() - 1);
        return new LeaderColumn.LeaderLabel(
                name, last.getX(), last.getY(), paper.ink(), look.color());
    }

    /** Names the lines to the right of the plot. */
    static void name(Graphics2D graphics, List<LeaderColumn.LeaderLabel> labels, Rectangle2D plot) {
        new LeaderColumn(labels, plot.getMaxX() + 24, plot.getMinY(), plot.getMaxY())
                .paint(graphics, MARK / 2.0 + 2);
    }
}
