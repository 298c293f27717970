package rasterlab.engine.plan;

import java.util.Optional;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.Patch;
import rasterlab.engine.scene.shape.SceneShape;
import rasterlab.engine.scene.shape.SurfacePoint;

/**
 * A shape made in steps, and how far its flat faces are from the surface.
 *
 * <p>Over a step of arc length s a surface of curvature κ rises κs²/8 above its chord. That rise is
 * largest half way, so it is measured there: at the middles of a cell's sides and of its diagonal,
 * along which a quadrilateral is cut. The diagonal's also holds the part s·s′·|P_uv|/4 by which the
 * places of a texture are drawn aside. Normals are compared in the same places.
 *
 * <p>Where rows are few, a profile may bend both ways within one, so that it is compared at more
 * places than the middle. A flat part is off at its border alone: it needs no steps of its own.
 *
 * <p>On the outline a place may be seen with the normal of any place of its step, since a rise
 * κs²/8 hides or shows as much: there the normal is off by up to half of what it turns over the
 * step.
 *
 * <p>Source: D. Filip, R. Magedson, R. Markot, Surface algorithms using bounds on derivatives,
 * Computer Aided Geometric Design 3(4), 1986, pp. 295–311.
 *
 * @param u steps once round
 * @param v steps across
 * @param faces that they make
 * @param sag the largest distance of a face from the surface, world units
 * @param bend the largest angle by which a normal that is seen is off, radians
 */
record ShapeSteps(int u, int v, int faces, double sag, double bend) {
    /** The part of the largest rise that the middles may miss. */
    private static final double ROOM = 1.1;

    /** Columns of cells that are looked at. */
    private static final int COLUMNS = 24;

    /** Where rows are fewer, a profile is compared at {@value #PLACES} places of each. */
    private static final int BENT = 16;

    private static final int PLACES = 7;

    /** Rows and columns of a first look. */
    private static final int FEW = 4;

    static ShapeSteps of(SceneShape shape, int u, int v) {
        return of(shape, u, v, COLUMNS, Integer.MAX_VALUE);
    }

    /** Looks at a few cells only: rise and angle are at least what comes of it. */
    static ShapeSteps atLeast(SceneShape shape, int u, int v) {
        return of(shape, u, v, FEW, FEW);
    }

    private static ShapeSteps of(SceneShape shape, int u, int v, int columns, int rows) {
        int faces = 0;
        double sag = 0;
        double bend = 0;
        for (Patch patch : shape.patches()) {
            int across = patch.vSteps(v);
            faces += u * across;
            var cell = new Cell(patch, rows > FEW && across < BENT ? PLACES : 1);
            int some = Math.min(u, columns);
            int few = Math.min(across, rows);
            for (int i = 0; i < some; i++)
                for (int k = 0; k < few; k++) {
                    int column = (int) ((long) i * u / some);
                    int j = (int) ((long) k * across / few);
                    cell.look(
                            at(patch.u().from(), patch.u().to(), column, u),
                            at(patch.u().from(), patch.u().to(), column + 1, u),
                            at(patch.v().from(), patch.v().to(), j, across),
                            at(patch.v().from(), patch.v().to(), j + 1, across));
                }
            sag = Math.max(sag, cell.sag);
            bend = Math.max(bend, cell.bend);
        }
        return new ShapeSteps(u, v, faces, ROOM * sag, ROOM * bend);
    }

    private static double at(double from, double to, int k, int steps) {
        return k == steps ? to : from + (to - from) * k / steps;
    }

    /**
     * The steps in which the faces of a scene's finish were made from its shape; empty where they
     * were not.
     */
    static Optional<ShapeSteps> found(Scene scene, SceneShape shape, int finish) {
        Mesh mesh = scene.mesh();
        int first = -1;
        int faces = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            if (scene.finishNumber(f) == finish) {
                if (first < 0) first = f;
                faces++;
            }
        if (first < 0) return Optional.empty();
        Patch patch = shape.patches().get(0);
        var point = new SurfacePoint();
        int least = patch.u().round() ? 3 : 1;
        for (int u = least; u <= faces; u++) {
            int v = faces % u == 0 ? rows(shape, faces / u) : 0;
            if (v == 0) continue;
            int corner = mesh.corner(first, mesh.cornerCount(first) - 2);
            double low = patch.v().from();
            double high = at(low, patch.v().to(), 1, patch.vSteps(v));
            patch.at(at(patch.u().from(), patch.u().to(), 1, u), high, point);
            double size = Math.abs(point.x()) + Math.abs(point.y()) + Math.abs(point.z());
            double apart =
                    Math.abs(mesh.x(corner) - point.x())
                            + Math.abs(mesh.y(corner) - point.y())
                            + Math.abs(mesh.z(corner) - point.z());
            if (apart <= 1e-9 * (1 + size)) return Optional.of(of(shape, u, v));
        }
        return Optional.empty();
    }

    /** The steps of v for which all patches together have so many rows; 0 for none. */
    private static int rows(SceneShape shape, int rows) {
        for (int v = rows; v > 0; v--) {
            int all = 0;
            for (Patch patch : shape.patches()) all += patch.vSteps(v);
            if (all == rows) return v;
            if (all < rows) return 0;
        }
        return 0;
    }

    /** The fewest steps of v that a plan makes: no poles and no way round need but one. */
    static int fewestRows(SceneShape shape) {
        int fewest = 1;
        for (Patch patch : shape.patches()) {
            boolean poles = patch.isPole(patch.v().from()) || patch.isPole(patch.v().to());
            if (patch.vSteps(2) > 1 && (patch.v().round() || poles)) fewest = 3;
        }
        return fewest;
    }

    /** The fewest steps of u that a plan makes. */
    static int fewestColumns(SceneShape shape) {
        return shape.patches().stream().anyMatch(patch -> patch.u().round()) ? 4 : 1;
    }

    /** One cell's corners and the places between them. */
    private static final class Cell {
        private final Patch patch;
        private final int places;
        private final SurfacePoint point = new SurfacePoint();
        private double sag;
        private double bend;

        /**
         * @param places between two rows that are compared
         */
        Cell(Patch patch, int places) {
            this.patch = patch;
            this.places = places;
        }

        void look(double u0, double u1, double v0, double v1) {
            double[] a = at(u0, v0);
            double[] b = at(u1, v0);
            double[] c = at(u1, v1);
            double[] d = at(u0, v1);
            double u = (u0 + u1) / 2;
            if (patch.isFlat()) {
                border(a, b, u, v0);
                border(d, c, u, v1);
                return;
            }
            compare(a, b, 0.5, u, v0);
            compare(d, c, 0.5, u, v1);
            for (int k = 1; k <= places; k++) {
                double part = (double) k / (places + 1);
                double v = v0 + part * (v1 - v0);
                compare(a, d, part, u0, v);
                compare(b, c, part, u1, v);
                compare(a, c, part, u0 + part * (u1 - u0), v);
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
            double dot = 0;
            double length = 0;
            for (int i = 0; i < 3; i++) {
                double mixed = p[3 + i] + part * (q[3 + i] - p[3 + i]);
                dot += mixed * there[3 + i];
                length += mixed * mixed;
            }
            sag = Math.max(sag, apart(p, q, part, there));
            if (patch.isPole(v)) return;
            sag = Math.max(sag, drawnAside(p, q, part, there));
            double cosine = length > 0 ? dot / Math.sqrt(length) : -1;
            bend = Math.max(bend, Math.acos(Math.max(-1, Math.min(1, cosine))));
            double turned = p[3] * q[3] + p[4] * q[4] + p[5] * q[5];
            bend = Math.max(bend, Math.acos(Math.max(-1, Math.min(1, turned))) / 2);
        }

        /** How far a texture is drawn aside, in the share of the way that its coordinates are. */
        private static double drawnAside(double[] p, double[] q, double part, double[] there) {
            double aside =
                    Math.hypot(
                            p[6] + part * (q[6] - p[6]) - there[6],
                            p[7] + part * (q[7] - p[7]) - there[7]);
            if (aside < 1e-12) return 0;
            double way = Math.hypot(q[6] - p[6], q[7] - p[7]);
            double x = q[0] - p[0];
            double y = q[1] - p[1];
            double z = q[2] - p[2];
            return aside / way * Math.sqrt(x * x + y * y + z * z);
        }
    }
}
