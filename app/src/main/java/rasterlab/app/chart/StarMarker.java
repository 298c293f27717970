package rasterlab.app.chart;

import java.awt.Graphics2D;
import java.awt.geom.Path2D;
import org.knowm.xchart.style.markers.Marker;

/** A star with five points, for the user's own program. */
final class StarMarker extends Marker {
    private static final int CORNERS = 10;

    /** Radius of the corners between the points, beside that of the points. */
    private static final double INNER = 0.45;

    /** How many times as wide as another mark, which covers more of its square. */
    private static final double WIDER = 1.7;

    @Override
    public void paint(Graphics2D g, double x, double y, int size) {
        var star = new Path2D.Double();
        for (int i = 0; i < CORNERS; i++) {
            double radius = WIDER * size / 2 * (i % 2 == 0 ? 1 : INNER);
            double angle = 2 * Math.PI * i / CORNERS;
            double atX = x + radius * Math.sin(angle);
            double atY = y - radius * Math.cos(angle);
            if (i == 0) star.moveTo(atX, atY);
            else star.lineTo(atX, atY);
        }
        star.closePath();
        g.fill(star);
    }
}
