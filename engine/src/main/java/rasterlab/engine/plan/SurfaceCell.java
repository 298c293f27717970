package rasterlab.engine.plan;

import rasterlab.engine.scene.shape.Patch;
import rasterlab.engine.scene.shape.SurfacePoint;

/**
 * How far the flat faces of a surface's cells are from it: the most of all cells that were looked
 * at, with a tenth for what lies between the places that are compared.
 */
final class SurfaceCell {
    /** The part of the largest rise that the compared places may miss. */
    private static final double ROOM = 1.1;

    private final Patch patch;
    private final int places;
    private final SurfacePoint point = new SurfacePoint();
    private double sag;
    private double mixed;
    private double turn;
    private double rate;

    /**
     * @param places along each side and the diagonal that are compared
     */
    SurfaceCell(Patch patch, int places) {
        this.patch = patch;
        this.places = places;
    }

    /** The largest distance of a face from the surface, world units. */
    double sag() {
        return ROOM * sag;
    }

    /** The largest angle between a normal mixed from corners and the surface's, radians. */
    double mixed() {
        return ROOM * mixed;
    }

    /** The largest angle that normals turn by over a cell, radians. */
    double turn() {
        return ROOM * turn;
    }

    /** The most that normals turn by for each world unit of a cell, radians. */
    double rate() {
        return ROOM * rate;
    }

    /** Looks at the cell between two u and two v. */
    void look(double u0, double u1, double v0, double v1) {
        double[] a = at(u0, v0);
        double[] b = at(u1, v0);
        double[] c = at(u1, v1);
        double[] d = at(u0, v1);
        if (patch.isFlat()) {
            double u = (u0 + u1) / 2;
            border(a, b, u, v0);
            border(d, c, u, v1);
            return;
        }
        for (int k = 1; k <= places; k++) {
            double part = (double) k / (places + 1);
            double u = u0 + part * (u1 - u0);
            double v = v0 + part * (v1 - v0);
            compare(a, b, part, u, v0);
            compare(d, c, part, u, v1);
            compare(a, d, part, u0, v);
            compare(b, c, part, u1, v);
            compare(a, c, part, u, v);
        }
    }

    /** A side of a flat patch, which is off the surface only if it is one of its border. */
    private void border(double[] p, double[] q, double u, double v) {
        boolean end = v == patch.v().from() || v == patch.v().to();
        if (end) sag = Math.max(sag, apart(p, q, 0.5, at(u, v)));
    }

    private double[] at(double u, double v) {
        patch.at(u, v, point);
        return new double[] {
            point.x(),
            point.y(),
            point.z(),
            point.normalX(),
            point.normalY(),
            point.normalZ(),
            point.s(),
            point.t()
        };
    }

    private static double apart(double[] p, double[] q, double part, double[] there) {
        double off = 0;
        for (int i = 0; i < 3; i++) {
            double aside = p[i] + part * (q[i] - p[i]) - there[i];
            off += aside * aside;
        }
        return Math.sqrt(off);
    }

    private void compare(double[] p, double[] q, double part, double u, double v) {
        double[] there = at(u, v);
        sag = Math.max(sag, apart(p, q, part, there));
        if (patch.isPole(v)) return;
        sag = Math.max(sag, drawnAside(p, q, part, there));
        double dot = 0;
        double square = 0;
        for (int i = 3; i < 6; i++) {
            double normal = p[i] + part * (q[i] - p[i]);
            dot += normal * there[i];
            square += normal * normal;
        }
        mixed = Math.max(mixed, angle(square > 0 ? dot / Math.sqrt(square) : -1));
        double turned = angle(p[3] * q[3] + p[4] * q[4] + p[5] * q[5]);
        turn = Math.max(turn, turned);
        double way = length(p, q);
        if (way > 0) rate = Math.max(rate, turned / way);
    }

    private static double angle(double cosine) {
        return Math.acos(Math.max(-1, Math.min(1, cosine)));
    }

    private static double length(double[] p, double[] q) {
        return Math.hypot(Math.hypot(q[0] - p[0], q[1] - p[1]), q[2] - p[2]);
    }

    /** How far a texture is drawn aside, in the share of the way that its coordinates are. */
    private static double drawnAside(double[] p, double[] q, double part, double[] there) {
        double aside =
                Math.hypot(
                        p[6] + part * (q[6] - p[6]) - there[6],
                        p[7] + part * (q[7] - p[7]) - there[7]);
        if (aside < 1e-12) return 0;
        double way = Math.hypot(q[6] - p[6], q[7] - p[7]);
        return aside / way * length(p, q);
    }
}
