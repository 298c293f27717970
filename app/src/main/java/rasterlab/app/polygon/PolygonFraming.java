package rasterlab.app.polygon;

import java.awt.geom.Rectangle2D;
import java.util.List;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.FillFigure;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.SeedFigure;

/** Chooses which part of the plane the stage shows when the user has not zoomed. */
final class PolygonFraming {
    /** Room around a triangle or polygon whose surroundings are judged, as a share of its size. */
    private static final double AROUND = 0.12;

    private PolygonFraming() {}

    static Rectangle2D of(PolygonFigure figure) {
        if (figure instanceof FillFigure fill) return pixels(fill.width(), fill.height());
        if (figure instanceof SeedFigure seed) return pixels(seed.width(), seed.height());
        if (figure instanceof CutFigure cut) return around(cut.corners());
        Rectangle2D box = around(((InsideFigure) figure).corners());
        for (PolygonPoint point : ((InsideFigure) figure).points()) box.add(point.x(), point.y());
        double more = AROUND * Math.max(box.getWidth(), box.getHeight());
        return new Rectangle2D.Double(
                box.getX() - more,
                box.getY() - more,
                box.getWidth() + 2 * more,
                box.getHeight() + 2 * more);
    }

    /** The view adds a margin, of which pixels need less: their part is shown a little larger. */
    private static Rectangle2D pixels(int width, int height) {
        double less = 0.085;
        return new Rectangle2D.Double(
                width * less - 0.5,
                height * less - 0.5,
                width * (1 - 2 * less),
                height * (1 - 2 * less));
    }

    private static Rectangle2D around(List<PolygonPoint> places) {
        var box = new Rectangle2D.Double(places.get(0).x(), places.get(0).y(), 0, 0);
        places.forEach(place -> box.add(place.x(), place.y()));
        return box;
    }
}
