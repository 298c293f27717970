package rasterlab.engine.clip.polygon;

import java.util.Arrays;
import rasterlab.contract.PolygonSink;

/**
 * The polygon cut by the line of one side of the window after the other.
 *
 * <p>Each cut goes round the corners: one within the line is kept, and where an edge passes the
 * line its crossing is added. So the result is always one ring: where a non-convex subject falls
 * into pieces, they stay joined by bridges to and fro along the window's sides. The area is right,
 * since a bridge has none, the number of pieces is not.
 *
 * <p>Which side of a line a corner is on is decided exactly; a crossing is p + t·(q − p), t = d/(d
 * − e), d and e being the distances of p and q from the line, in doubles where these carry enough
 * digits, otherwise without rounding.
 *
 * <p>At last the ring may have no area: a touched side, bridges only. The crossings' rounding can
 * make that a little and a thin piece nothing, so a ring that is not clearly large is sent only if
 * subject and window, as given, share points inside both ({@link Overlap}), and three corners or
 * more are left of it.
 *
 * <p>Source: I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM
 * 17(1), 1974, pp. 32–42.
 */
public final class SutherlandHodgman implements SteppedPolygonClipper {
    @Override
    public PolygonWalk walk(double[] window, double[] subject) {
        return new Walk(ConvexWindow.of(window), Ring.simple(subject));
    }

    private static final class Walk implements PolygonWalk {
        private final Ring window;
        private final Ring subject;
        private final SideCrossing crossing;
        private double[] polygon;
        private double[] cut = new double[16];
        private int size;
        private int side;
        private long sideTests;

        Walk(Ring window, Ring subject) {
            this.window = window;
            this.subject = subject;
            crossing = new SideCrossing(window);
            polygon = subject.xy();
        }

        /** Cuts the polygon by the line of the next side, edge after edge from last to corner. */
        @Override
        public boolean advance() {
            if (side == window.size() || polygon.length == 0) return false;
            size = 0;
            int last = polygon.length - 2;
            int closingSide = sideOf(last);
            int lastSide = closingSide;
            for (int corner = 0; corner < polygon.length; corner += 2) {
                boolean closing = corner == polygon.length - 2;
                int thisSide = closing ? closingSide : sideOf(corner);
                boolean passesLine = lastSide * thisSide < 0;
                if (passesLine) addCrossing(last, corner);
                if (thisSide >= 0) add(polygon[corner], polygon[corner + 1]);
                last = corner;
                lastSide = thisSide;
            }
            polygon = Ring.withoutRepeats(Arrays.copyOf(cut, size));
            side++;
            return true;
        }

        /** Decides exactly: 1 within the line of the current side, 0 on it, −1 beyond it. */
        private int sideOf(int corner) {
            sideTests++;
            return window.side(side, polygon[corner], polygon[corner + 1]);
        }

        /** Adds the point p + t·(q − p) at which the edge from corner p to q passes the line. */
        private void addCrossing(int from, int to) {
            double[] point =
                    crossing.of(
                            side, polygon[from], polygon[from + 1], polygon[to], polygon[to + 1]);
            add(point[0], point[1]);
        }

        private void add(double x, double y) {
            if (size == cut.length) cut = Arrays.copyOf(cut, 2 * size);
            cut[size++] = x;
            cut[size++] = y;
        }

        @Override
        public String at() {
            return side == 0 ? "" : "side " + (side - 1);
        }

        @Override
        public double[] polygon() {
            return polygon.clone();
        }

        @Override
        public double[] passage() {
            return new double[0];
        }

        @Override
        public long sideTests() {
            return sideTests;
        }

        @Override
        public long divisions() {
            return crossing.divisions();
        }

        @Override
        public long unroundedCrossings() {
            return crossing.unrounded();
        }

        @Override
        public void send(PolygonSink out) {
            if (isLeft()) out.polygon(polygon.clone());
        }

        private boolean isLeft() {
            return polygon.length >= 6
                    && (PolygonArea.isClear(polygon, window.xy())
                            || Overlap.isAny(window, subject));
        }
    }
}
