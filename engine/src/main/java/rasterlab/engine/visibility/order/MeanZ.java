package rasterlab.engine.visibility.order;

import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import rasterlab.contract.PieceSink;

/**
 * The painter's order: polygons by the mean depth of their corners, the largest first.
 *
 * <p>A mean says nothing about polygons that overlap in depth, which is where it errs; nothing is
 * ever cut. Equal means keep the order of the input.
 */
final class MeanZ implements SteppedOrder {
    @Override
    public OrderWalk walk(Sight sight, PieceSink out, Runnable pulse) {
        return new Walk(sight, out);
    }

    @Override
    public String decision() {
        return "mean depth z of the corners, in units of the input";
    }

    private static final class Walk implements OrderWalk {
        private final List<Facet> facets;
        private final double[] depth;
        private final PieceSink out;
        private final Iterator<Integer> order;
        private long comparisons;
        private OrderStep step;

        Walk(Sight sight, PieceSink out) {
            facets = sight.facets();
            this.out = out;
            var frame = new EyeFrame(facets);
            depth = new double[facets.size()];
            int exponent = sight.exponent();
            Arrays.setAll(depth, k -> Math.scalb(mean(frame, facets.get(k).seen()), exponent));
            order =
                    IntStream.range(0, depth.length)
                            .boxed()
                            .sorted(this::fartherFirst)
                            .toList()
                            .iterator();
        }

        private static double mean(EyeFrame frame, double[] seen) {
            int corners = seen.length / 3;
            double sum = 0;
            for (int i = 0; i < corners; i++) sum += frame.z(seen, i);
            return sum / corners;
        }

        private int fartherFirst(int a, int b) {
            comparisons++;
            return Double.compare(depth[b], depth[a]);
        }

        @Override
        public boolean advance() {
            if (!order.hasNext()) return false;
            int next = order.next();
            out.piece(next, facets.get(next).corners());
            step = OrderStep.paint(next, depth[next]);
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
