package rasterlab.engine.visibility;

import rasterlab.engine.raster.Raster;

/** One face over whatever the picture holds: its fill, then its outline. */
final class FaceBrush {
    private FaceBrush() {}

    static void paint(ScreenPolygon polygon, int face, FacePaint paint, Raster out) {
        polygon.fill(
                out.width(), out.height(), (y, from, to) -> paint.span(face, y, from, to, out));
        if (paint.hasOutline()) new OutlineStroke(out, paint.outline(face)).around(polygon);
    }
}
