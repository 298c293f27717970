package rasterlab.engine.visibility;

import java.util.Arrays;
import rasterlab.engine.raster.Raster;

/** One face over whatever the picture holds: its fill, then its outline. */
final class FaceBrush {
    private FaceBrush() {}

    static void paint(ScreenPolygon polygon, int face, FacePaint paint, Raster out) {
        int[] argb = out.argb();
        int width = out.width();
        int fill = paint.fill()[face];
        polygon.fill(
                width,
                out.height(),
                (y, from, to) -> Arrays.fill(argb, y * width + from, y * width + to, fill));
        if (paint.hasOutline()) new OutlineStroke(out, paint.outline()[face]).around(polygon);
    }
}
