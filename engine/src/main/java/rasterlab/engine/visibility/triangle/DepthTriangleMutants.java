package rasterlab.engine.visibility.triangle;

import java.util.List;
import rasterlab.contract.DepthTriangleFiller;
import rasterlab.engine.study.Mutant;

/** Triangles filled into a depth buffer with one mistake. */
final class DepthTriangleMutants {
    private static final DepthTriangleFiller RIGHT = new RowsTriangle();
    private static final Owner OWNED = TrianglePlane::owns;
    private static final Depth DEPTH = TrianglePlane::depth;
    private static final Test NEARER = (depth, stored) -> depth < stored;

    private DepthTriangleMutants() {}

    static List<Mutant<DepthTriangleFiller>> all() {
        return List.of(
                new Mutant<>(
                        "last-pixel-included",
                        "on-the-edges",
                        new Changed(DepthTriangleMutants::closed, DEPTH, NEARER)),
                new Mutant<>(
                        "one-way-round",
                        "either-way-round",
                        new Changed((p, x, y) -> p.area() > 0 && p.owns(x, y), DEPTH, NEARER)),
                new Mutant<>(
                        "depth-in-whole-numbers",
                        "nearer-first",
                        new Changed(OWNED, (p, x, y) -> (int) p.depth(x, y), NEARER)),
                new Mutant<>(
                        "depth-in-float",
                        "close-together",
                        new Changed(OWNED, (p, x, y) -> (float) p.depth(x, y), NEARER)),
                new Mutant<>(
                        "depth-at-the-corner",
                        "slanted",
                        new Changed(OWNED, (p, x, y) -> p.depth(x - 0.5, y - 0.5), NEARER)),
                new Mutant<>(
                        "test-reversed",
                        "before-a-wall",
                        new Changed(OWNED, DEPTH, (depth, stored) -> depth > stored)),
                new Mutant<>(
                        "later-of-equal-wins",
                        "same-again",
                        new Changed(OWNED, DEPTH, (depth, stored) -> depth <= stored)),
                new Mutant<>(
                        "no-test",
                        "nearer-first",
                        new Changed(OWNED, DEPTH, (depth, stored) -> true)),
                new Mutant<>(
                        "depth-not-stored",
                        "nearer-first",
                        (x, y, z, number, width, height, depths, shown) ->
                                RIGHT.fill(x, y, z, number, width, height, depths.clone(), shown)),
                new Mutant<>(
                        "zeros-of-its-own", "one-triangle", DepthTriangleMutants::zerosOfItsOwn),
                new Mutant<>("lower-edge-end", "on-the-edges", new ByRows(true, false, false)),
                new Mutant<>("depth-at-the-edge", "slanted", new ByRows(false, true, false)),
                new Mutant<>(
                        "cut-columns-not-counted",
                        "beyond-the-picture",
                        new ByRows(false, false, true)));
    }

    /** Looks at a buffer that nobody filled with the depth of the background. */
    private static void zerosOfItsOwn(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown) {
        RIGHT.fill(x, y, z, number, width, height, new double[depths.length], shown);
    }

    /** Takes the centres on all edges. */
    private static boolean closed(TrianglePlane plane, double x, double y) {
        if (plane.area() == 0) return false;
        for (int i = 0; i < 3; i++) if (plane.inward(i, x, y) < 0) return false;
        return true;
    }

    private interface Owner {
        boolean owns(TrianglePlane plane, double x, double y);
    }

    private interface Depth {
        double at(TrianglePlane plane, double x, double y);
    }

    private interface Test {
        boolean passes(double depth, double stored);
    }

    /** Looks at every pixel of the picture. */
    private record Changed(Owner owner, Depth depth, Test test) implements DepthTriangleFiller {
        @Override
        public void fill(
                double[] x,
                double[] y,
                double[] z,
                int number,
                int width,
                int height,
                double[] depths,
                int[] shown) {
            var plane = new TrianglePlane(x, y, z);
            for (int at = 0; at < depths.length; at++) {
                int column = at % width;
                int row = at / width;
                if (!owner.owns(plane, column, row)) continue;
                double found = depth.at(plane, column, row);
                if (!test.passes(found, depths[at])) continue;
                depths[at] = found;
                shown[at] = number;
            }
        }
    }

    /**
     * Goes along the rows and steps the depth.
     *
     * @param lower whether an edge counts in the row of its lower end, not of its upper one
     * @param edge whether a row begins with the depth on its left edge
     * @param cut whether a row cut off at the left begins with the depth of its first pixel outside
     */
    private record ByRows(boolean lower, boolean edge, boolean cut) implements DepthTriangleFiller {
        @Override
        public void fill(
                double[] x,
                double[] y,
                double[] z,
                int number,
                int width,
                int height,
                double[] depths,
                int[] shown) {
            var plane = new TrianglePlane(x, y, z);
            if (plane.area() == 0) return;
            for (int row = 0; row < height; row++) {
                double left = Double.POSITIVE_INFINITY;
                double right = Double.NEGATIVE_INFINITY;
                for (int i = 0; i < 3; i++) {
                    int j = (i + 1) % 3;
                    if (above(y[i], row) == above(y[j], row)) continue;
                    double at = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                    left = Math.min(left, at);
                    right = Math.max(right, at);
                }
                double first = edge ? left : Math.ceil(left);
                int from = (int) Math.max(0, Math.ceil(left));
                double skipped = cut ? 0 : from - Math.ceil(left);
                for (int column = from; column < Math.min(width, Math.ceil(right)); column++) {
                    double depth = plane.depth(first + skipped + column - from, row);
                    int at = row * width + column;
                    if (!(depth < depths[at])) continue;
                    depths[at] = depth;
                    shown[at] = number;
                }
            }
        }

        private boolean above(double y, int row) {
            return lower ? y < row : y <= row;
        }
    }
}
