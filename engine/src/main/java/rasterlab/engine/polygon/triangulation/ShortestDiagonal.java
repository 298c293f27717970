package rasterlab.engine.polygon.triangulation;

/**
 * Cuts off the ear with the shortest diagonal, again and again.
 *
 * <p>The course's method with what it lacks: corners must not lie in the triangle that is cut, the
 * corners may go either way round, and the sign of a turn is exact instead of compared with 10⁻⁶.
 * Of equal diagonals the first round the polygon is cut.
 *
 * <p>Each cut looks at all ears: n²/2 diagonals for n corners. At most {@value
 * EarClipping#MOST_CORNERS} corners are taken.
 *
 * <p>Source: V. V. Ponomarev, Computer graphics (Mashinnaya grafika), Ozyorsk, 2006, fig. 82, with
 * the ears of G. H. Meisters, Polygons have ears, American Mathematical Monthly 82, 1975, pp.
 * 648–651.
 */
final class ShortestDiagonal implements SteppedTriangulator {
    @Override
    public TriangleWalk walk(double[] x, double[] y) {
        return new Walk(Corners.ofSimple(x, y, EarClipping.MOST_CORNERS));
    }

    @Override
    public String choice() {
        return "the ear with the least (xj − xh)² + (yj − yh)²";
    }

    private static final class Walk implements TriangleWalk {
        private final EarRing ring;
        private final boolean[] ear;
        private int start;
        private int a;
        private int b;
        private int c;

        Walk(Corners corners) {
            ring = new EarRing(corners);
            ear = new boolean[corners.size()];
            findEars();
            start = 0;
            while (!ring.contains(start)) start++;
        }

        private void findEars() {
            for (int i = 0; i < ear.length; i++) ear[i] = ring.contains(i) && ring.isEar(i);
        }

        @Override
        public boolean advance() {
            if (ring.size() < 3) return false;
            b = shortest();
            if (b < 0) {
                findEars();
                b = shortest();
            }
            if (b < 0) throw EarRing.crosswise();
            a = ring.previous(b);
            c = ring.next(b);
            for (int changed : ring.cut(b))
                ear[changed] = ring.contains(changed) && ring.isEar(changed);
            for (int i = start; !ring.contains(start); ) start = ++i % ear.length;
            return true;
        }

        private int shortest() {
            int best = -1;
            double least = 0;
            int i = start;
            for (int k = 0; k < ring.size(); k++, i = ring.next(i)) {
                if (!ear[i]) continue;
                double diagonal = ring.diagonal(i);
                if (best < 0 || diagonal < least) {
                    best = i;
                    least = diagonal;
                }
            }
            return best;
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
