package rasterlab.engine.circle;

import rasterlab.engine.raster.PixelPredicate;
import rasterlab.engine.raster.PixelRecording;

/**
 * The pixels by which a figure is judged that has too many to keep: those in squares about the four
 * points on its axes and about the four where columns give way to rows, which is where methods
 * fail.
 */
final class ArcSample implements PixelPredicate {
    /** Pixels from a square's middle to its sides: eight hold less than a million of a curve's. */
    private static final long REACH = 30_000;

    private final Ellipse figure;
    private final long cornerU;
    private final long cornerV;

    ArcSample(Ellipse figure) {
        this.figure = figure;
        double diagonal = Math.max(1, Math.hypot(figure.radiusX(), figure.radiusY()));
        cornerU = Math.round(figure.radiusX() * (figure.radiusX() / diagonal));
        cornerV = Math.round(figure.radiusY() * (figure.radiusY() / diagonal));
    }

    @Override
    public boolean test(int x, int y) {
        return inQuadrant(
                Math.abs((long) x - figure.centerX()), Math.abs((long) y - figure.centerY()));
    }

    private boolean inQuadrant(long u, long v) {
        return near(u, 0) && near(v, figure.radiusY())
                || near(u, figure.radiusX()) && near(v, 0)
                || near(u, cornerU) && near(v, cornerV);
    }

    private static boolean near(long coordinate, long middle) {
        return Math.abs(coordinate - middle) <= REACH;
    }

    /** The right pixels. */
    PixelRecording exact(int limit) {
        int a = figure.radiusX();
        int b = figure.radiusY();
        var exact = new ExactEllipse(a, b);
        var recording = new PixelRecording(limit);
        for (long u = 0; u <= a; u = next(u, a, cornerU)) {
            int v = exact.row((int) u);
            if (inQuadrant(u, v)) keep((int) u, v, recording, limit);
        }
        for (long v = 0; v <= b; v = next(v, b, cornerV)) {
            int u = exact.column((int) v);
            if (inQuadrant(u, v) && exact.row(u) != v) keep(u, (int) v, recording, limit);
        }
        return recording;
    }

    /** The next coordinate that is near 0, the corner or the end. */
    private static long next(long from, long end, long corner) {
        long to = from + 1;
        if (to > REACH && to < corner - REACH) to = corner - REACH;
        if (to > REACH && to > corner + REACH && to < end - REACH) to = end - REACH;
        return to;
    }

    private void keep(int u, int v, PixelRecording recording, int limit) {
        for (int x = -u; ; x = u) {
            for (int y = -v; ; y = v) {
                if (recording.size() < limit)
                    recording.plot(figure.centerX() + x, figure.centerY() + y);
                if (y == v) break;
            }
            if (x == u) break;
        }
    }
}
