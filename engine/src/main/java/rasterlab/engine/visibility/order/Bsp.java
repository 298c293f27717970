package rasterlab.engine.visibility.order;

import java.util.Map;
import rasterlab.contract.PieceSink;

/** Far side, plane, near side, at every node of a tree of planes: {@link BspTree}. */
final class Bsp implements SteppedOrder {
    @Override
    public OrderWalk walk(Sight sight, PieceSink out) {
        return new Walk(sight, out);
    }

    @Override
    public String decision() {
        return "distance from the eye to the plane, in units of the input";
    }

    private static final class Walk implements OrderWalk {
        private final PieceSink out;
        private final int exponent;
        private final BspTree tree;
        private final BspTree.Tour tour;
        private OrderStep step;

        Walk(Sight sight, PieceSink out) {
            this.out = out;
            exponent = sight.exponent();
            tree = new BspTree(sight.facets());
            tour = tree.tour();
        }

        @Override
        public boolean advance() {
            if (!tour.hasNext()) return false;
            Facet next = tour.next();
            out.piece(next.polygon(), next.corners());
            double distance = Math.scalb(-next.plane().c(), exponent);
            step = OrderStep.paint(next.polygon(), distance);
            return true;
        }

        @Override
        public OrderStep step() {
            return step;
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("comparisons", tree.comparisons(), "splits", tree.splits());
        }
    }
}
