package rasterlab.engine.polygon.triangulation;

import java.util.ArrayDeque;

/**
 * Cuts off one ear after another, as {@link EarRing} tells them.
 *
 * <p>Cutting an ear changes only what its two neighbours are, so each corner is tried once and each
 * neighbour of a cut once more: at most 3·n tries for n corners, each against the corners that are
 * not convex. At most {@value #MOST_CORNERS} corners are taken.
 *
 * <p>Source: G. H. Meisters, Polygons have ears, American Mathematical Monthly 82, 1975, pp.
 * 648–651.
 */
public final class EarClipping implements SteppedTriangulator {
    /**
     * The most corners that are taken: a few seconds if all of them are in the way of each other.
     */
    public static final int MOST_CORNERS = 20_000;

    @Override
    public TriangleWalk walk(double[] x, double[] y) {
        return new Walk(Corners.ofSimple(x, y, MOST_CORNERS));
    }

    @Override
    public String choice() {
        return "the next corner round the polygon that is an ear";
    }

    private static final class Walk implements TriangleWalk {
        private final EarRing ring;
        private final ArrayDeque<Integer> toTry = new ArrayDeque<>();
        private final int all;
        private boolean cutSince;
        private int a;
        private int b;
        private int c;

        Walk(Corners corners) {
            ring = new EarRing(corners);
            tryAll(corners.size());
            all = corners.size();
        }

        private void tryAll(int corners) {
            for (int i = 0; i < corners; i++) if (ring.contains(i)) toTry.add(i);
            cutSince = false;
        }

        @Override
        public boolean advance() {
            if (ring.size() < 3) return false;
            int ear = next();
            while (!ring.contains(ear) || !ring.isEar(ear)) ear = next();
            cutSince = true;
            a = ring.previous(ear);
            b = ear;
            c = ring.next(ear);
            for (int changed : ring.cut(ear)) toTry.add(changed);
            return true;
        }

        /** Some corner of a simple polygon is always an ear. */
        private int next() {
            if (toTry.isEmpty()) {
                if (!cutSince) throw EarRing.crosswise();
                tryAll(all);
            }
            return toTry.remove();
        }

        @Override
        public int a() {
            return ring.number(a);
        }

        @Override
        public int b() {
            return ring.number(b);
        }

        @Override
        public int c() {
            return ring.number(c);
        }

        @Override
        public long turns() {
            return ring.turns();
        }
    }
}
