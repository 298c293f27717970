package rasterlab.engine.polygon.scan;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.contract.FillRule;

/**
 * A polygon row by row: the crossings of a row with the active edges, from left to right.
 *
 * <p>Each active edge gives the first column at or right of its crossing and its direction. In the
 * sorted list of these columns the winding number changes at each, and a span reaches from where it
 * becomes inside to where it stops to be. Crossings that share a column count together, so no span
 * is empty and no two touch. Columns are decided without rounding, by {@link PolygonEdge}.
 *
 * <p>Source: C. Wylie, G. Romney, D. Evans, A. Erdahl, Half-tone perspective drawings by computer,
 * AFIPS 1967, pp. 49–58.
 */
public final class ScanlinePolygon implements SteppedPolygon {
    @Override
    public SpanWalk walk(double[] x, double[] y, FillRule rule, int width, int height) {
        PolygonCheck.check(x, y, width, height);
        return new Walk(new ScanlineEdges(PolygonEdge.crossing(x, y, height), height), rule, width);
    }

    private static final class Walk implements SpanWalk {
        private final ScanlineEdges edges;
        private final FillRule rule;
        private final int width;

        /** The row's crossings from left to right: twice the column, and 1 more where downward. */
        private int[] crossings = new int[16];

        private int count;
        private int next;
        private int winding;
        private int from;
        private int to;
        private long computed;

        Walk(ScanlineEdges edges, FillRule rule, int width) {
            this.edges = edges;
            this.rule = rule;
            this.width = width;
        }

        @Override
        public boolean advance() {
            while (next < count || nextRow()) {
                boolean wasInside = rule.inside(winding);
                int column = crossings[next] >> 1;
                while (next < count && crossings[next] >> 1 == column)
                    winding += 2 * (crossings[next++] & 1) - 1;
                boolean isInside = rule.inside(winding);
                if (!wasInside && isInside) from = column;
                if (wasInside && !isInside) {
                    to = column;
                    return true;
                }
            }
            return false;
        }

        private boolean nextRow() {
            if (!edges.nextRow()) return false;
            count = edges.size();
            next = 0;
            if (crossings.length < count) crossings = new int[2 * count];
            for (int i = 0; i < count; i++) {
                PolygonEdge edge = edges.edge(i);
                int column = edge.firstColumn(edges.row(), width);
                crossings[i] = 2 * column + (edge.winding() > 0 ? 1 : 0);
            }
            Arrays.sort(crossings, 0, count);
            computed += count;
            return true;
        }

        @Override
        public int y() {
            return edges.row();
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
        public List<RowCrossing> row() {
            return edges.crossings(width);
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("crossings", computed);
        }
    }
}
