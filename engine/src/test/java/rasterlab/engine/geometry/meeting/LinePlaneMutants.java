package rasterlab.engine.geometry.meeting;

import java.util.List;
import rasterlab.contract.LinePlane;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Mutants;

/** Lines met with a plane with one mistake. */
final class LinePlaneMutants implements Mutants<LinePlane> {
    private static final LinePlane RIGHT = new UnroundedMeeting();

    @Override
    public List<Mutant<LinePlane>> all() {
        return List.of(
                new Mutant<>(
                        "a parallel line is met at its first point",
                        "parallel",
                        (n, c, p, q) ->
                                slope(n, p, q) == 0 && at(n, p) != c ? 0 : RIGHT.meets(n, c, p, q)),
                new Mutant<>(
                        "a line in the plane is met at its first point",
                        "in-the-plane",
                        (n, c, p, q) ->
                                at(n, p) == c && at(n, q) == c ? 0 : RIGHT.meets(n, c, p, q)),
                new Mutant<>(
                        "counted from the second point",
                        "three-points",
                        (n, c, p, q) -> RIGHT.meets(n, c, q, p)),
                new Mutant<>(
                        "n·p* is taken for 0 where it is below an epsilon",
                        "vanishing-slope",
                        (n, c, p, q) -> {
                            if (Math.abs(slope(n, p, q)) < 1e-12)
                                throw new IllegalArgumentException("line is parallel");
                            return RIGHT.meets(n, c, p, q);
                        }),
                new Mutant<>(
                        "sums of products in doubles",
                        "nearly-parallel",
                        (n, c, p, q) -> (c - at(n, p)) / slope(n, p, q)),
                new Mutant<>(
                        "products overflow",
                        "huge",
                        (n, c, p, q) ->
                                Double.isFinite(slope(n, p, q))
                                        ? RIGHT.meets(n, c, p, q)
                                        : Double.NaN),
                new Mutant<>(
                        "the plane's point is rounded into c",
                        "plane-far-away",
                        (n, c, p, q) -> RIGHT.meets(n, c, p, q)),
                new Mutant<>(
                        "μ is kept to sixteen places, and with it the point",
                        "point-near-the-start",
                        (n, c, p, q) -> {
                            double mu = RIGHT.meets(n, c, p, q);
                            return Math.abs(mu) < 1e-16 ? 0 : mu;
                        }),
                new Mutant<>(
                        "the second point counts as beyond",
                        "at-the-second-point",
                        new BeyondAtOnce()));
    }

    private static double at(double[] n, double[] p) {
        return n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
    }

    /** n·(q − p). */
    private static double slope(double[] n, double[] p, double[] q) {
        return n[0] * (q[0] - p[0]) + n[1] * (q[1] - p[1]) + n[2] * (q[2] - p[2]);
    }

    /** What is right but for μ = 1, of which it makes a little more. */
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
