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
 * @param mixed the largest angle between a normal mixed from corners and the surface's, radians
 * @param turn the largest angle that normals turn by over a step, radians
 */
record ShapeSteps(int u, int v, int faces, double sag, double mixed, double turn) {
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
        double mixed = 0;
        double turn = 0;
        for (Patch patch : shape.patches()) {
            int across = patch.vSteps(v);
            faces += u * across;
            var cell = new SurfaceCell(patch, rows > FEW && across < BENT ? PLACES : 1);
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
            sag = Math.max(sag, cell.sag());
            mixed = Math.max(mixed, cell.mixed());
            turn = Math.max(turn, cell.turn());
        }
        return new ShapeSteps(u, v, faces, sag, mixed, turn);
    }

    /** The largest angle by which a normal that is seen is off, on the outline too, radians. */
    double bend() {
        return Math.max(mixed, turn / 2);
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
}
