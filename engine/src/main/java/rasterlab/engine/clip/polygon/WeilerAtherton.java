package rasterlab.engine.clip.polygon;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeMap;
import rasterlab.contract.PolygonSink;

/**
 * Clips by walking along the subject while it is inside the window, along the window's rim while it
 * is not.
 *
 * <p>Both rings are counter-clockwise. Where the subject's boundary leaves the window, the piece
 * goes on along the rim to the next place where the boundary enters, and from there along the
 * boundary again, until it is back where it began. So each piece is a ring of its own.
 *
 * <p>Corners on the rim and edges along it need no case of their own: only parts strictly inside
 * the window count as inside ({@link InnerChain}), and places on the rim are ordered without
 * rounding. Where a corner touches the rim from inside, the boundary leaves and enters at one
 * place: a corner turning left goes straight on, one turning right leaves the rim on both sides to
 * the subject, and the piece goes on to the next place.
 *
 * <p>Source: K. Weiler, P. Atherton, Hidden surface removal using polygon area sorting, Computer
 * Graphics (SIGGRAPH) 11(2), 1977, pp. 214–222.
 */
public final class WeilerAtherton implements SteppedPolygonClipper {
    @Override
    public PolygonWalk walk(double[] window, double[] subject) {
        return new Walk(ConvexWindow.of(window), Ring.simple(subject));
    }

    private static final class Walk implements PolygonWalk {
        private final Ring window;
        private final InnerChains cut;
        private final List<InnerChain> chains;
        private final TreeMap<RimPoint, InnerChain> entering = new TreeMap<>();
        private final List<double[]> pieces = new ArrayList<>();
        private double[] piece = new double[16];
        private int size;
        private int next;
        private InnerChain first;
        private InnerChain chain;
        private InnerChain followed;

        Walk(Ring window, Ring subject) {
            this.window = window;
            cut = new InnerChains(window, subject);
            chains = cut.chains();
            for (InnerChain each : chains) entering.put(each.enter(), each);
            if (chains.isEmpty())
                Enclosure.of(window, subject).ifPresent(ring -> pieces.add(ring.xy()));
        }

        /** Follows one chain and the rim behind it. */
        @Override
        public boolean advance() {
            if (chain == null && !begin()) return false;
            entering.remove(chain.enter());
            add(chain.enter().x(), chain.enter().y());
            for (int i = 0; i < chain.corners().length; i += 2)
                add(chain.corners()[i], chain.corners()[i + 1]);
            add(chain.leave().x(), chain.leave().y());
            followed = chain;
            InnerChain following = following();
            addRim(chain.leave(), following.enter());
            chain = following == first ? close() : following;
            return true;
        }

        private boolean begin() {
            while (next < chains.size() && !entering.containsKey(chains.get(next).enter())) next++;
            if (next == chains.size()) return false;
            first = chains.get(next);
            chain = first;
            size = 0;
            return true;
        }

        /** The chain that enters next along the rim; the first of the piece is still to be met. */
        private InnerChain following() {
            entering.put(first.enter(), first);
            var place = chain.leave();
            var found =
                    chain.touchesHollow()
                            ? entering.higherEntry(place)
                            : entering.ceilingEntry(place);
            return (found == null ? entering.firstEntry() : found).getValue();
        }

        private InnerChain close() {
            entering.remove(first.enter());
            double[] ring = Ring.withoutRepeats(Arrays.copyOf(piece, size));
            if (ring.length >= 6) pieces.add(ring);
            return null;
        }

        /** Adds the window's corners between two places on its rim. */
        private void addRim(RimPoint from, RimPoint to) {
            int corners = Math.floorMod(to.side() - from.side(), window.size());
            if (corners == 0 && from.compareTo(to) > 0) corners = window.size();
            for (int i = 1; i <= corners; i++)
                add(window.x(from.side() + i), window.y(from.side() + i));
        }

        private void add(double x, double y) {
            if (size + 2 > piece.length) piece = Arrays.copyOf(piece, 2 * piece.length);
            piece[size++] = x;
            piece[size++] = y;
        }

        @Override
        public String at() {
            if (followed == null) return "";
            return "chain from (" + followed.enter().x() + ", " + followed.enter().y() + ")";
        }

        @Override
        public double[] polygon() {
            return Ring.withoutRepeats(Arrays.copyOf(piece, size));
        }

        @Override
        public double[] passage() {
            if (followed == null) return new double[0];
            RimPoint enter = followed.enter();
            RimPoint leave = followed.leave();
            return new double[] {enter.x(), enter.y(), leave.x(), leave.y()};
        }

        @Override
        public long sideTests() {
            return cut.sideTests();
        }

        /** No divisions: places on the rim are fractions. */
        @Override
        public long divisions() {
            return 0;
        }

        @Override
        public long unroundedCrossings() {
            return cut.unroundedCrossings();
        }

        @Override
        public void send(PolygonSink out) {
            for (double[] each : pieces) out.polygon(each.clone());
        }
    }
}
