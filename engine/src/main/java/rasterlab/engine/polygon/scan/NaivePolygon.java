package rasterlab.engine.polygon.scan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import rasterlab.contract.FillRule;

/**
 * A polygon row by row as one writes it first, kept because each of its faults teaches a rule.
 *
 * <p>Both ends of an edge count, so a row through a corner meets two edges there and pairs them
 * wrongly. Both ends of a span are rounded and filled, so polygons that share an edge draw its
 * pixels twice. Crossings are paired, so every outline is filled by the even-odd rule.
 */
public final class NaivePolygon implements SteppedPolygon {
    @Override
    public SpanWalk walk(double[] x, double[] y, FillRule rule, int width, int height) {
        PolygonCheck.check(x, y, width, height);
        return new Walk(x, y, width, height);
    }

    private static final class Walk implements SpanWalk {
        private final double[] x;
        private final double[] y;
        private final int width;
        private final int height;

        /** The row's crossings from left to right, and how many there are. */
        private final double[] crossings;

        private int count;
        private int next;
        private int row = -1;
        private int from;
        private int to;
        private long edges;

        Walk(double[] x, double[] y, int width, int height) {
            this.x = x;
            this.y = y;
            this.width = width;
            this.height = height;
            crossings = new double[x.length];
        }

        @Override
        public boolean advance() {
            while (next + 1 < count || nextRow()) {
                if (next + 1 >= count) continue;
                from = (int) Math.max(0, Math.rint(crossings[next]));
                to = (int) Math.min(width - 1, Math.rint(crossings[next + 1])) + 1;
                next += 2;
                if (from < to) return true;
            }
            return false;
        }

        private boolean nextRow() {
            if (row + 1 >= height) return false;
            row++;
            count = 0;
            next = 0;
            for (int i = 0, before = x.length - 1; i < x.length; before = i++) cross(before, i);
            Arrays.sort(crossings, 0, count);
            return true;
        }

        private void cross(int i, int j) {
            edges++;
            if (meets(i, j)) crossings[count++] = crossing(i, j);
        }

        private boolean meets(int i, int j) {
            if (y[i] == y[j]) return false;
            double share = (row - y[i]) / (y[j] - y[i]);
            return share >= 0 && share <= 1;
        }

        private double crossing(int i, int j) {
            return x[i] + (row - y[i]) / (y[j] - y[i]) * (x[j] - x[i]);
        }

        @Override
        public List<RowCrossing> row() {
            var met = new ArrayList<RowCrossing>();
            for (int i = 0, before = x.length - 1; i < x.length; before = i++)
                if (meets(before, i)) met.add(listed(before, i));
            met.sort(Comparator.comparingDouble(RowCrossing::x));
            return met;
        }

        private RowCrossing listed(int from, int to) {
            boolean down = y[from] < y[to];
            int upper = down ? from : to;
            int lower = down ? to : from;
            double at = crossing(from, to);
            int column = (int) Math.max(0, Math.min(width, Math.rint(at)));
            return new RowCrossing(
                    x[upper], y[upper], x[lower], y[lower], at, column, down ? 1 : -1);
        }

        @Override
        public int y() {
            return row;
        }

        @Override
        public int from() {
            return from;
        }

        @Override
        public int to() {
            return to;
        }

        @Override
        public int crossings() {
            return count;
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("edges", edges);
        }
    }
}
