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
            var cell = new Cell(patch);
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
        if (first < 0 || shape.patches().size() != 1) return Optional.empty();
        Patch patch = shape.patches().get(0);
        var point = new SurfacePoint();
        int least = patch.u().round() ? 3 : 1;
        for (int u = least; u <= faces; u++) {
            if (faces % u != 0 || patch.vSteps(faces / u) != faces / u) continue;
            int corner = mesh.corner(first, mesh.cornerCount(first) - 2);
            double low = patch.v().from();
            double high = at(low, patch.v().to(), 1, faces / u);
            patch.at(at(patch.u().from(), patch.u().to(), 1, u), high, point);
            double size = Math.abs(point.x()) + Math.abs(point.y()) + Math.abs(point.z());
            double apart =
                    Math.abs(mesh.x(corner) - point.x())
                            + Math.abs(mesh.y(corner) - point.y())
                            + Math.abs(mesh.z(corner) - point.z());
            if (apart <= 1e-9 * (1 + size)) return Optional.of(of(shape, u, faces / u));
        }
        return Optional.empty();
    }

    /** One cell's corners and the places between them. */
    private static final class Cell {
        private final Patch patch;
        private final SurfacePoint point = new SurfacePoint();
        private double sag;
        private double bend;

        Cell(Patch patch) {
            this.patch = patch;
        }

        void look(double u0, double u1, double v0, double v1) {
            double[] a = at(u0, v0);
            double[] b = at(u1, v0);
            double[] c = at(u1, v1);
            double[] d = at(u0, v1);
            double u = (u0 + u1) / 2;
            double v = (v0 + v1) / 2;
            compare(a, b, u, v0);
            compare(d, c, u, v1);
            compare(a, d, u0, v);
            compare(b, c, u1, v);
            compare(a, c, u, v);
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

        private void compare(double[] p, double[] q, double u, double v) {
            double[] there = at(u, v);
            double off = 0;
            double dot = 0;
            double length = 0;
            for (int i = 0; i < 3; i++) {
                double middle = (p[i] + q[i]) / 2 - there[i];
                off += middle * middle;
                double mixed = (p[3 + i] + q[3 + i]) / 2;
                dot += mixed * there[3 + i];
                length += mixed * mixed;
            }
            sag = Math.max(sag, Math.sqrt(off));
            if (patch.isPole(v)) return;
            sag = Math.max(sag, drawnAside(p, q, there));
            double cosine = length > 0 ? dot / Math.sqrt(length) : -1;
            bend = Math.max(bend, Math.acos(Math.max(-1, Math.min(1, cosine))));
            double turned = p[3] * q[3] + p[4] * q[4] + p[5] * q[5];
            bend = Math.max(bend, Math.acos(Math.max(-1, Math.min(1, turned))) / 2);
        }

        /** How far a texture is drawn aside, in the share of the way that its coordinates are. */
        private static double drawnAside(double[] p, double[] q, double[] there) {
            double aside = Math.hypot((p[6] + q[6]) / 2 - there[6], (p[7] + q[7]) / 2 - there[7]);
            if (aside < 1e-12) return 0;
            double way = Math.hypot(q[6] - p[6], q[7] - p[7]);
            double x = q[0] - p[0];
            double y = q[1] - p[1];
            double z = q[2] - p[2];
            return aside / way * Math.sqrt(x * x + y * y + z * z);
        }
    }
}
