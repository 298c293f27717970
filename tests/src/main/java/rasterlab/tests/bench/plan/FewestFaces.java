package rasterlab.tests.bench.plan;

import rasterlab.engine.range.Bounds;
import rasterlab.engine.scene.shape.Patch;
import rasterlab.engine.scene.shape.SurfacePoint;

/**
 * The fewest faces of a surface of revolution that stay near it, by trying all steps in both
 * directions.
 *
 * <p>All columns of such a surface are alike. A place of a face is as far off as from the surface's
 * place with the same parameters, whose light and texture it shows.
 *
 * @param uSteps steps once round
 * @param vSteps steps across
 * @param discs that close it, which have a face for each step once round
 */
record FewestFaces(int uSteps, int vSteps, int discs) {
    FewestFaces {
        Bounds.requireAtLeast("uSteps", uSteps, 1);
        Bounds.requireAtLeast("vSteps", vSteps, 1);
    }

    private static final int COARSEST = 3;

    /** Places that are looked at along each side of a face. */
    private static final int PLACES = 8;

    int faces() {
        return uSteps * (vSteps + discs);
    }

    /**
     * Tries all steps up to the finest ones; for each u the fewest v by halving.
     *
     * @param discs that close the surface
     * @param most the distance allowed, world units; the finest steps must be within it
     */
    static FewestFaces of(Patch patch, int discs, double most, int finestU, int finestV) {
        var best = new FewestFaces(finestU, finestV, discs);
        for (int u = COARSEST; u * (COARSEST + discs) < best.faces() && u <= finestU; u++) {
            int high = Math.min(finestV, (best.faces() - 1) / u - discs);
            if (distance(patch, u, high) > most) continue;
            int low = COARSEST;
            while (low < high) {
                int middle = (low + high) / 2;
                if (distance(patch, u, middle) <= most) high = middle;
                else low = middle + 1;
            }
            best = new FewestFaces(u, high, discs);
        }
        return best;
    }

    /** The farthest that faces made in steps are from the surface, world units. */
    static double distance(Patch patch, int u, int v) {
        double from = patch.u().from();
        double to = from + (patch.u().to() - from) / u;
        double most = 0;
        for (int row = 0; row < v; row++)
            most =
                    Math.max(
                            most,
                            distance(patch, from, to, at(patch, row, v), at(patch, row + 1, v)));
        return most;
    }

    private static double at(Patch patch, int row, int rows) {
        double from = patch.v().from();
        return row == rows ? patch.v().to() : from + (patch.v().to() - from) * row / rows;
    }

    private static double distance(Patch patch, double u0, double u1, double v0, double v1) {
        double[][] corners = {
            place(patch, u0, v0), place(patch, u1, v0), place(patch, u0, v1), place(patch, u1, v1)
        };
        double most = 0;
        for (int i = 0; i <= PLACES; i++)
            for (int j = 0; j <= PLACES; j++) {
                double a = (double) i / PLACES;
                double b = (double) j / PLACES;
                double[] there = place(patch, u0 + a * (u1 - u0), v0 + b * (v1 - v0));
                double off = 0;
                // Two triangles, as the pipeline cuts it, mixed from their corners.
                double[] aside = a > b ? corners[1] : corners[2];
                for (int axis = 0; axis < 3; axis++) {
                    double apart =
                            (1 - Math.max(a, b)) * corners[0][axis]
                                    + Math.abs(a - b) * aside[axis]
                                    + Math.min(a, b) * corners[3][axis]
                                    - there[axis];
                    off += apart * apart;
                }
                most = Math.max(most, Math.sqrt(off));
            }
        return most;
    }

    private static double[] place(Patch patch, double u, double v) {
        var point = new SurfacePoint();
        patch.at(u, v, point);
        return new double[] {point.x(), point.y(), point.z()};
    }
}
