package rasterlab.engine.clip.polygon;

import java.util.Arrays;
import rasterlab.contract.PolygonSink;

/**
 * Sutherland and Hodgman's clipping as it is printed: the sides of corners and the crossings in
 * doubles, and what the last side leaves is the answer.
 *
 * <p>A corner p is within the side from a to b if d = (b − a) × (p − a) is at least 0, so that the
 * window has to go counter-clockwise; an edge from p to q crosses it at p + d/(d − e)·(q − p).
 * Nothing is checked: a polygon that only touches the window leaves a piece without area, corners
 * are sent twice, d overflows from numbers of 10¹⁵⁴ on, and what is no polygon gets an answer.
 *
 * <p>Source: J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes, Computer Graphics: Principles and
 * Practice, 1990, chapter 3.
 */
public final class SutherlandHodgmanTextbook implements SteppedPolygonClipper {
    @Override
    public PolygonWalk walk(double[] window, double[] subject) {
        return new Walk(window, subject);
    }

    private static final class Walk implements PolygonWalk {
        private final double[] window;
        private double[] polygon;
        private double[] left = new double[16];
        private int size;
        private int side;
        private long tests;
        private long divisions;

        Walk(double[] window, double[] subject) {
            this.window = window.clone();
            polygon = subject.clone();
        }

        @Override
        public boolean advance() {
            if (2 * side >= window.length || polygon.length == 0) return false;
            size = 0;
            int from = polygon.length - 2;
            for (int to = 0; to < polygon.length; to += 2) {
                double d = distance(from);
                double e = distance(to);
                if (e >= 0) {
                    if (d < 0) addCrossing(from, to, d, e);
                    add(polygon[to], polygon[to + 1]);
                } else if (d >= 0) addCrossing(from, to, d, e);
                from = to;
            }
            polygon = Arrays.copyOf(left, size);
            side++;
            return true;
        }

        /** The distance of a corner from the side's line, times the side's length. */
        private double distance(int corner) {
            tests++;
            int a = 2 * side;
            int b = (a + 2) % window.length;
            return (window[b] - window[a]) * (polygon[corner + 1] - window[a + 1])
                    - (window[b + 1] - window[a + 1]) * (polygon[corner] - window[a]);
        }

        private void addCrossing(int from, int to, double d, double e) {
            divisions++;
            double share = d / (d - e);
            add(
                    polygon[from] + share * (polygon[to] - polygon[from]),
                    polygon[from + 1] + share * (polygon[to + 1] - polygon[from + 1]));
        }

        private void add(double x, double y) {
            if (size == left.length) left = Arrays.copyOf(left, 2 * size);
            left[size++] = x;
            left[size++] = y;
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
            return tests;
        }

        @Override
        public long divisions() {
            return divisions;
        }

        @Override
        public long unroundedCrossings() {
            return 0;
        }

        @Override
        public void send(PolygonSink out) {
            if (polygon.length > 0) out.polygon(polygon.clone());
        }
    }
}
