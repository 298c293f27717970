package rasterlab.engine.visibility.order;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.contract.PieceSink;

/**
 * Polygons by their farthest corners, with every doubt about overlapping depths resolved by five
 * tests, moves and cuts.
 *
 * <p>P, the farthest left, is painted if for each Q that overlaps it in depth one of {@link
 * FiveTests} shows that P hides nothing of Q. Otherwise Q is marked and takes P's place. A marked Q
 * is not moved again: it waits for P, so the two belong to a circle of polygons, each of which has
 * to wait for the next. Then one of the circle is cut: by the plane of its neighbour if it has
 * corners on both sides, else along an edge of its neighbour's outline, which always divides one
 * unless all outlines are the same, and those are in no circle.
 *
 * <p>Cuts end, as each piece is cut by a plane at most once, and so do moves, as between two cuts
 * each polygon is marked at most once before one is painted.
 *
 * <p>Source: M. E. Newell, R. G. Newell, T. L. Sancha, A solution to the hidden surface problem,
 * ACM Annual Conference, 1972, pp. 443–450.
 */
final class Newell implements SteppedOrder {
    /** The most pieces, against inputs whose cuts would fill the memory. */
    private static final int MOST_PIECES = 1_000_000;

    /** The most pairs of polygons that are compared: some seconds. */
    private static final long MOST_COMPARISONS = 500_000_000;

    private final int mostPieces;
    private final long mostComparisons;

    Newell() {
        this(MOST_PIECES, MOST_COMPARISONS);
    }

    /** One that gives up earlier. */
    Newell(int mostPieces, long mostComparisons) {
        this.mostPieces = mostPieces;
        this.mostComparisons = mostComparisons;
    }

    @Override
    public OrderWalk walk(Sight sight, PieceSink out, Runnable pulse) {
        return new Walk(sight, out, pulse);
    }

    @Override
    public String decision() {
        return "largest depth z of a corner of the polygon or piece, in units of the input";
    }

    private final class Walk implements OrderWalk {
        private final PieceSink out;
        private final Runnable pulse;
        private final EyeFrame frame;
        private final int exponent;
        private final FiveTests tests = new FiveTests();
        private final Deque<Facet> edgeOn = new ArrayDeque<>();
        private final DepthList left = new DepthList();

        /** P is the last; each before it is marked and waits for the next. */
        private final List<FacetExtent> waiting = new ArrayList<>();

        private final int polygons;
        private long splits;
        private OrderStep step;
        private List<Cut> cuts = List.of();

        Walk(Sight sight, PieceSink out, Runnable pulse) {
            this.out = out;
            this.pulse = pulse;
            exponent = sight.exponent();
            List<Facet> facets = sight.facets();
            polygons = facets.size();
            frame = new EyeFrame(facets);
            for (Facet facet : facets)
                if (facet.plane().holdsEye()) edgeOn.add(facet);
                else left.add(extent(facet));
        }

        private FacetExtent extent(Facet facet) {
            return new FacetExtent(facet, frame);
        }

        @Override
        public boolean advance() {
            pulse.run();
            if (!edgeOn.isEmpty()) {
                Facet facet = edgeOn.remove();
                give(facet);
                step = OrderStep.paint(facet.polygon(), mostDepth(facet));
                return true;
            }
            if (waiting.isEmpty()) {
                if (left.isEmpty()) return false;
                waiting.add(left.removeFarthest());
            }
            resolve(waiting.get(waiting.size() - 1));
            requireEndInSight();
            return true;
        }

        private void requireEndInSight() {
            requireAtMost(mostPieces, "pieces", polygons + splits);
            requireAtMost(mostComparisons, "comparisons", tests.comparisons());
        }

        private void requireAtMost(long most, String what, long count) {
            if (count > most)
                throw new IllegalArgumentException(
                        "%d polygons must need at most %d %s, got %d with %d pieces left to paint"
                                .formatted(
                                        polygons, most, what, count, left.size() + waiting.size()));
        }

        private void give(Facet facet) {
            cuts = facet.cuts();
            out.piece(facet.polygon(), facet.corners());
        }

        private double mostDepth(Facet facet) {
            double most = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < facet.seen().length / 3; i++)
                most = Math.max(most, frame.z(facet.seen(), i));
            return Math.scalb(most, exponent);
        }

        /** Paints P, moves one before it, or cuts one of a circle. */
        private void resolve(FacetExtent p) {
            int marked = hiddenAmongMarked(p);
            if (marked >= 0) {
                if (!cutCircle(marked)) paint(p);
                return;
            }
            left.firstHidden(p, tests).ifPresentOrElse(q -> move(q, p), () -> paint(p));
        }

        private void move(FacetExtent q, FacetExtent p) {
            left.remove(q);
            waiting.add(q);
            step = step(OrderStep.OrderStepKind.MOVE, q, p);
        }

        private OrderStep step(OrderStep.OrderStepKind kind, FacetExtent one, FacetExtent other) {
            double depth = Math.scalb(one.mostZ(), exponent);
            return new OrderStep(kind, one.facet().polygon(), other.facet().polygon(), depth);
        }

        private void paint(FacetExtent p) {
            waiting.remove(waiting.size() - 1);
            give(p.facet());
            step = step(OrderStep.OrderStepKind.PAINT, p, p);
        }

        /** The place of the first marked polygon of which P may hide something, or −1. */
        private int hiddenAmongMarked(FacetExtent p) {
            for (int i = 0; i < waiting.size() - 1; i++)
                if (tests.mayHide(p, waiting.get(i))) return i;
            return -1;
        }

        /**
         * Cuts one polygon of the circle that begins at {@code from} in the waiting list.
         *
         * @return whether one could be cut; if not, they are level within the tolerance
         */
        private boolean cutCircle(int from) {
            int last = waiting.size() - 1;
            if (cutOneOf(waiting.get(last), waiting.get(from))) return true;
            for (int i = from; i < last; i++)
                if (cutOneOf(waiting.get(i), waiting.get(i + 1))) return true;
            return false;
        }

        private boolean cutOneOf(FacetExtent a, FacetExtent b) {
            if (cut(a, b, b.facet().plane()) || cut(b, a, a.facet().plane())) return true;
            return cutAlongEdges(a, b) || cutAlongEdges(b, a);
        }

        private boolean cutAlongEdges(FacetExtent one, FacetExtent by) {
            for (int edge = 0; edge < by.facet().seen().length / 3; edge++)
                if (cut(one, by, EyePlane.throughEdge(by.facet(), edge))) return true;
            return false;
        }

        /**
         * Cuts one if it has corners on both sides. What waited for it still does; those that came
         * after it are sorted in again with its pieces.
         */
        private boolean cut(FacetExtent one, FacetExtent by, EyePlane plane) {
            if (plane.sides(one.facet().seen()) != (EyePlane.NEAR | EyePlane.FAR)) return false;
            splits++;
            List<FacetExtent> later = waiting.subList(waiting.indexOf(one), waiting.size());
            for (FacetExtent each : later) if (each != one) left.add(each);
            later.clear();
            for (Facet piece : one.facet().cut(plane)) left.add(extent(piece));
            step = step(OrderStep.OrderStepKind.CUT, one, by);
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
            var counts = new TreeMap<>(tests.operations());
            counts.put("splits", splits);
            return counts;
        }
    }
}
