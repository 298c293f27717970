package rasterlab.engine.geometry.meeting;

import java.util.List;
import rasterlab.contract.LinePlane;
import rasterlab.engine.study.Mutant;

/** Lines met with a plane with one mistake. */
final class LinePlaneMutants {
    private static final LinePlane RIGHT = new UnroundedMeeting();

    private LinePlaneMutants() {}

    static List<Mutant<LinePlane>> all() {
        return List.of(
                new Mutant<>(
                        "parallel-met-at-start",
                        "parallel",
                        (n, c, p, q) ->
                                slope(n, p, q) == 0 && at(n, p) != c ? 0 : RIGHT.meets(n, c, p, q)),
                new Mutant<>(
                        "in-plane-met-at-start",
                        "in-the-plane",
                        (n, c, p, q) ->
                                at(n, p) == c && at(n, q) == c ? 0 : RIGHT.meets(n, c, p, q)),
                new Mutant<>(
                        "from-the-second-point",
                        "three-points",
                        (n, c, p, q) -> RIGHT.meets(n, c, q, p)),
                new Mutant<>(
                        "slope-epsilon",
                        "vanishing-slope",
                        (n, c, p, q) -> {
                            if (Math.abs(slope(n, p, q)) < 1e-12)
                                throw new IllegalArgumentException("line is parallel");
                            return RIGHT.meets(n, c, p, q);
                        }),
                new Mutant<>(
                        "sums-in-double",
                        "nearly-parallel",
                        (n, c, p, q) -> (c - at(n, p)) / slope(n, p, q)),
                new Mutant<>(
                        "products-overflow",
                        "huge",
                        (n, c, p, q) ->
                                Double.isFinite(slope(n, p, q))
                                        ? RIGHT.meets(n, c, p, q)
                                        : (c - at(n, p)) / slope(n, p, q)),
                new Mutant<>(
                        "plane-point-rounded",
                        "plane-far-away",
                        (n, c, p, q) -> RIGHT.meets(n, c, p, q)),
                new Mutant<>(
                        "sixteen-decimal-places",
                        "point-near-the-start",
                        (n, c, p, q) -> {
                            double mu = RIGHT.meets(n, c, p, q);
                            return Math.abs(mu) < 1e-16 ? 0 : mu;
                        }),
                new Mutant<>("second-point-beyond", "at-the-second-point", new BeyondAtOnce()));
    }

    private static double at(double[] n, double[] p) {
        return n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
    }

    /** n·(q − p). */
    private static double slope(double[] n, double[] p, double[] q) {
        return n[0] * (q[0] - p[0]) + n[1] * (q[1] - p[1]) + n[2] * (q[2] - p[2]);
    }

    /** The right answer but for μ = 1, of which it makes a little more. */
    private static final class BeyondAtOnce implements LinePlane {
        @Override
        public double meets(double[] n, double c, double[] p, double[] q) {
            return beyond(RIGHT.meets(n, c, p, q));
        }

        @Override
        public double meetsThrough(double[] n, double[] a, double[] p, double[] q) {
            return beyond(RIGHT.meetsThrough(n, a, p, q));
        }

        private static double beyond(double mu) {
            return mu == 1 ? Math.nextUp(mu) : mu;
        }
    }
}
