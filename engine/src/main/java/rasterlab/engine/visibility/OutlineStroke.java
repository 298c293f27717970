package rasterlab.engine.visibility;

import rasterlab.engine.line.RasterLine;
import rasterlab.engine.raster.Raster;

/**
 * The edges of a polygon, drawn between the corners' nearest pixels by {@link RasterLine}, which
 * enters the picture without walking there.
 *
 * <p>An edge that goes on beyond the range of int is first cut to a margin within it (Liang and
 * Barsky, 1984); seen from the picture it stays the uncut one to within half a pixel.
 */
final class OutlineStroke {
    private static final double MARGIN = 1 << 30;

    private final Raster out;
    private final int argb;
    private double enter;
    private double leave;

    OutlineStroke(Raster out, int argb) {
        this.out = out;
        this.argb = argb;
    }

    void around(ScreenPolygon polygon) {
        for (int k = 0, p = polygon.size() - 1; k < polygon.size(); p = k++)
            edge(polygon.x(p), polygon.y(p), polygon.x(k), polygon.y(k));
    }

    void edge(double x0, double y0, double x1, double y1) {
        double dx = x1 - x0;
        double dy = y1 - y0;
        enter = 0;
        leave = 1;
        boolean seen =
                keep(-dx, x0 + MARGIN)
                        && keep(dx, out.width() + MARGIN - x0)
                        && keep(-dy, y0 + MARGIN)
                        && keep(dy, out.height() + MARGIN - y0);
        if (!seen) return;
        RasterLine.draw(
                (int) Math.rint(x0 + enter * dx),
                (int) Math.rint(y0 + enter * dy),
                (int) Math.rint(x0 + leave * dx),
                (int) Math.rint(y0 + leave * dy),
                argb,
                out);
    }

    /** Cuts the parameters to {@code t · speed ≤ room}; false when nothing remains. */
    private boolean keep(double speed, double room) {
        if (speed == 0) return room >= 0;
        double t = room / speed;
        if (speed < 0) enter = Math.max(enter, t);
        else leave = Math.min(leave, t);
        return enter <= leave;
    }
}
