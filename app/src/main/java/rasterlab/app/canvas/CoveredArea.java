package rasterlab.app.canvas;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** Measures how much a label would hide. */
public final class CoveredArea {
    private CoveredArea() {}

    /** The areas that a place takes of what should be seen, added up. */
    public static double of(Rectangle place, List<? extends Rectangle2D> seen) {
        double area = 0;
        for (Rectangle2D each : seen) {
            Rectangle2D both = each.createIntersection(place);
            if (!both.isEmpty()) area += both.getWidth() * both.getHeight();
        }
        return area;
    }
}
