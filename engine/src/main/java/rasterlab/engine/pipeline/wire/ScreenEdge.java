package rasterlab.engine.pipeline.wire;

import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.visibility.EyeSegment;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * One edge at a time, cut at the near, the far and the clip planes and by the picture, in pixels.
 *
 * <p>Nearness is ρ/z in perspective and −z in parallel projection: linear in the pixel, larger for
 * what is nearer.
 */
final class ScreenEdge {
    /** Half a pixel: centres this far outside the rim still round to pixels inside. */
    private static final double RIM = 0.499;

    private final ViewedMesh view;
    private final double[] x = new double[2];
    private final double[] y = new double[2];
    private final double[] nearness = new double[2];
    private double enter;
    private double leave;

    ScreenEdge(ViewedMesh view) {
        this.view = view;
    }

    /** Takes a piece of a line; false when nothing of it can be seen. */
    boolean load(EyeSegment piece) {
        double dz = piece.z1() - piece.z0();
        enter = 0;
        leave = 1;
        if (!keep(-dz, piece.z0() - view.near()) || !keep(dz, view.far() - piece.z0()))
            return false;
        for (int plane = 0; plane < view.clipPlaneCount(); plane++) {
            double start = view.clipDistance(plane, piece.x0(), piece.y0(), piece.z0());
            double finish = view.clipDistance(plane, piece.x1(), piece.y1(), piece.z1());
            if (!keep(start - finish, start)) return false;
        }
        double first = enter;
        double last = leave;
        project(0, piece, first);
        project(1, piece, last);
        return cutByPicture();
    }

    private void project(int end, EyeSegment piece, double t) {
        double z = piece.z0() + t * (piece.z1() - piece.z0());
        double shrink = view.transform().central() ? view.transform().distance() / z : 1;
        double eyeX = piece.x0() + t * (piece.x1() - piece.x0());
        double eyeY = piece.y0() + t * (piece.y1() - piece.y0());
        x[end] = view.fit().toPixelX(eyeX * shrink);
        y[end] = view.fit().toPixelY(eyeY * shrink);
        nearness[end] = view.transform().central() ? shrink : -z;
    }

    private boolean cutByPicture() {
        PictureFit fit = view.fit();
        double dx = x[1] - x[0];
        double dy = y[1] - y[0];
        enter = 0;
        leave = 1;
        boolean inside =
                keep(-dx, x[0] + RIM)
                        && keep(dx, fit.width() - 1 + RIM - x[0])
                        && keep(-dy, y[0] + RIM)
                        && keep(dy, fit.height() - 1 + RIM - y[0]);
        if (!inside) return false;
        double from = enter;
        double to = leave;
        double nearFrom = nearness(from);
        double nearTo = nearness(to);
        double x0 = x[0];
        double y0 = y[0];
        x[0] = x0 + from * dx;
        y[0] = y0 + from * dy;
        x[1] = x0 + to * dx;
        y[1] = y0 + to * dy;
        nearness[0] = nearFrom;
        nearness[1] = nearTo;
        return true;
    }

    /** Cuts the parameters to {@code t · speed ≤ room}; false when nothing remains. */
    private boolean keep(double speed, double room) {
        if (speed == 0) return room >= 0;
        double t = room / speed;
        if (speed < 0) enter = Math.max(enter, t);
        else leave = Math.min(leave, t);
        return enter <= leave;
    }

    /** Steps along the longer axis, one pixel each. */
    int steps() {
        int first = (int) Math.rint(steep() ? y[0] : x[0]);
        int last = (int) Math.rint(steep() ? y[1] : x[1]);
        return Math.abs(last - first);
    }

    private boolean steep() {
        return Math.abs(y[1] - y[0]) > Math.abs(x[1] - x[0]);
    }

    /** The parameter of a step: where its pixel centre is on the longer axis, within the edge. */
    double parameter(int step) {
        double from = steep() ? y[0] : x[0];
        double length = (steep() ? y[1] : x[1]) - from;
        if (length == 0) return 0;
        double center = Math.rint(from) + Math.signum(length) * step;
        return Math.max(0, Math.min(1, (center - from) / length));
    }

    double x(double t) {
        return x[0] + t * (x[1] - x[0]);
    }

    double y(double t) {
        return y[0] + t * (y[1] - y[0]);
    }

    double nearness(double t) {
        return nearness[0] + t * (nearness[1] - nearness[0]);
    }
}
