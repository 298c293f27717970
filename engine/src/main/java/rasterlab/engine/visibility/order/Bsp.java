package rasterlab.engine.visibility.order;

import java.util.List;
import java.util.Map;
import rasterlab.contract.PieceSink;

/**
 * Far side, plane, near side, at every node of a tree of planes: {@link BspTree}.
 *
 * <p>Source: H. Fuchs, Z. M. Kedem, B. F. Naylor, On visible surface generation by a priori tree
 * structures, SIGGRAPH 1980, pp. 124–133.
 */
final class Bsp implements SteppedOrder {
    /** The most pieces, against inputs whose cuts would fill the memory. */
    private static final int MOST_PIECES = 1_000_000;

    private final int mostPieces;

    Bsp() {
        this(MOST_PIECES);
    }

    /** One that gives up earlier. */
    Bsp(int mostPieces) {
        this.mostPieces = mostPieces;
    }

    @Override
    public OrderWalk walk(Sight sight, PieceSink out, Runnable pulse) {
        return new Walk(sight, out, mostPieces, pulse);
    }

    @Override
    public String decision() {
        return "distance from the eye to the plane, in units of the input";
    }

    private static final class Walk implements OrderWalk {
        private final PieceSink out;
        private final int exponent;
        private final BspTree tree;
        private final BspTree.BspTraversal tour;
        private OrderStep step;
        private List<Cut> cuts = List.of();

        Walk(Sight sight, PieceSink out, int mostPieces, Runnable pulse) {
            this.out = out;
            exponent = sight.exponent();
            tree = new BspTree(sight.facets(), mostPieces, pulse);
            tour = tree.tour();
        }

        @Override
        public boolean advance() {
            if (!tour.hasNext()) return false;
            Facet next = tour.next();
            cuts = next.cuts();
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
        public List<Cut> cuts() {
            return cuts;
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("comparisons", tree.comparisons(), "splits", tree.splits());
        }
    }
}
