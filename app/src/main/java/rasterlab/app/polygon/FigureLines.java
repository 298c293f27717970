package rasterlab.app.polygon;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.List;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.polygon.figure.PolygonPoint;

/** Lines of a figure on the stage. */
final class FigureLines {
    /** The number of view units beyond which Java2D's own clipping loses precision. */
    private static final double FAR = 1e6;

    private final Graphics2D g;
    private final PlaneMap map;
    private final StageColors colors;

    FigureLines(Graphics2D g, PlaneMap map, StageColors colors) {
        this.g = g;
        this.map = map;
        this.colors = colors;
    }

    private double x(PolygonPoint place) {
        return near(map.viewX(place.x()));
    }

    private double y(PolygonPoint place) {
        return near(map.viewY(place.y()));
    }

    private static double near(double view) {
        return Math.max(-FAR, Math.min(FAR, view));
    }

    Path2D closed(List<PolygonPoint> places) {
        return ring(places, map);
    }

    /**
     * The path through the places in turn and back to the first one; those that are nowhere left
     * out.
     */
    static Path2D ring(List<PolygonPoint> places, PlaneMap map) {
        var path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        for (PolygonPoint place : places) {
            if (!place.isFinite()) continue;
            double x = near(map.viewX(place.x()));
            double y = near(map.viewY(place.y()));
            if (path.getCurrentPoint() == null) path.moveTo(x, y);
            else path.lineTo(x, y);
        }
        if (path.getCurrentPoint() != null) path.closePath();
        return path;
    }

    void outline(List<PolygonPoint> places, Color color, float width) {
        g.setColor(color);
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(closed(places));
    }

    void line(PolygonPoint from, PolygonPoint to, Color color, float width) {
        g.setColor(color);
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(new Line2D.Double(x(from), y(from), x(to), y(to)));
    }

    void dashed(PolygonPoint from, PolygonPoint to, Color color) {
        g.setColor(color);
        g.setStroke(
                new BasicStroke(
                        1.6f,
                        BasicStroke.CAP_BUTT,
                        BasicStroke.JOIN_ROUND,
                        10,
                        new float[] {5, 4},
                        0));
        g.draw(new Line2D.Double(x(from), y(from), x(to), y(to)));
    }

    void area(List<PolygonPoint> places, Color color, int alpha) {
        g.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha));
        g.fill(closed(places));
    }

    /** Where the plate of such words lies, in view units. */
    Rectangle plate(String words, PolygonPoint at, double right, double down) {
        FontMetrics metrics = g.getFontMetrics();
        int wide = metrics.stringWidth(words) + 8;
        int high = metrics.getHeight() + 1;
        return new Rectangle(
                (int) (x(at) + right - wide / 2.0),
                (int) (y(at) + down - metrics.getAscent() / 2.0) - 1,
                wide,
                high);
    }

    /** Words with their middle at a place, moved by so many view units. */
    void words(String words, PolygonPoint at, double right, double down) {
        Color ground = colors.ground();
        int wide = g.getFontMetrics().stringWidth(words);
        Plates.plate(
                g,
                words,
                (int) (x(at) + right - wide / 2.0),
                (int) (y(at) + down + g.getFontMetrics().getAscent() / 2.0),
                new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), 225),
                colors.ink());
    }
}
