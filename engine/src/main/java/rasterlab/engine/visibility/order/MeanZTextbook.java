package rasterlab.engine.visibility.order;

import java.util.List;
import java.util.Map;
import rasterlab.contract.PieceSink;

/**
 * The painter's order as the vase's coursework has it, faults included.
 *
 * <p>Depths are rounded to whole units before the eye's distance ρ is added, a polygon's depth is
 * the mean of its first three corners, and the next polygon is searched among all: N² comparisons.
 * Ties keep the order of the input.
 *
 * <p>Source: student's coursework "three-dimensional model of a vase", program listing.
 */
final class MeanZTextbook implements SteppedOrder {
    @Override
    public OrderWalk walk(Sight sight, PieceSink out, Runnable pulse) {
        return new Walk(sight, out);
    }

    @Override
    public String decision() {
        return "mean rounded depth z of the first three corners, in units of the input";
    }

    private static final class Walk implements OrderWalk {
        private final List<Facet> facets;
        private final double[] depth;
        private final boolean[] painted;
        private final PieceSink out;
        private int steps;
        private long comparisons;
        private OrderStep step;

        Walk(Sight sight, PieceSink out) {
            facets = sight.facets();
            this.out = out;
            depth = new double[facets.size()];
            painted = new boolean[facets.size()];
            var frame = new EyeFrame(facets);
            int exponent = sight.exponent();
            double rho = Math.scalb(frame.distance(), exponent);
            for (int k = 0; k < depth.length; k++) {
                double sum = 0;
                for (int i = 0; i < 3; i++) {
                    double z = Math.scalb(frame.z(facets.get(k).seen(), i), exponent);
                    sum += Math.rint(z - rho) + rho;
                }
                depth[k] = sum / 3;
            }
        }

        @Override
        public boolean advance() {
            if (steps == depth.length) return false;
            steps++;
            int farthest = -1;
            for (int k = 0; k < depth.length; k++) {
                if (painted[k]) continue;
                comparisons++;
                if (farthest < 0 || depth[k] > depth[farthest]) farthest = k;
            }
            painted[farthest] = true;
            out.piece(farthest, facets.get(farthest).corners());
            step = OrderStep.paint(farthest, depth[farthest]);
            return true;
        }

        @Override
        public OrderStep step() {
            return step;
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("comparisons", comparisons, "splits", 0L);
        }
    }
}
