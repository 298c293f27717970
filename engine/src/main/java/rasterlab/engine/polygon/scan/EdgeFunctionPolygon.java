package rasterlab.engine.polygon.scan;

import java.util.Arrays;
import java.util.Map;
import rasterlab.contract.FillRule;

/**
 * A polygon pixel by pixel: the signs of the edge functions of each pixel of the box around it.
 *
 * <p>E(x, y) = (x − x0)·(y1 − y0) − (y − y0)·(x1 − x0) is 0 on an edge from (x0, y0) down to (x1,
 * y1) and above 0 right of it. Of the edges that cross the pixel's row, those with E ≥ 0 add their
 * direction to its winding number; no crossing is computed, nothing is sorted, and no pixel needs
 * another's result. That suits triangles and parallel machines, and costs corners × pixels.
 *
 * <p>Source: J. Pineda, A parallel algorithm for polygon rasterization, SIGGRAPH 1988, pp. 17–20.
 */
public final class EdgeFunctionPolygon implements SteppedPolygon {
    /** The most edge functions: some seconds. */
    static final long MOST_FUNCTIONS = 1_000_000_000;

    @Override
    public SpanWalk walk(double[] x, double[] y, FillRule rule, int width, int height) {
        PolygonCheck.check(x, y, width, height);
        int left = firstColumn(Arrays.stream(x).min().orElse(0), width);
        int right = firstColumn(Arrays.stream(x).max().orElse(0), width);
        var edges = PolygonEdge.crossing(x, y, height);
        long functions = 0;
        for (PolygonEdge edge : edges)
            functions += (long) (right - left) * (edge.endRow(height) - edge.firstRow());
        if (functions > MOST_FUNCTIONS)
            throw new IllegalArgumentException(
                    "pixels × edges in their rows must be at most 1000000000, got " + functions);
        return new Walk(new ScanlineEdges(edges, height), rule, left, right);
    }

    /** The first column of the picture at or right of x; its width where there is none. */
    private static int firstColumn(double x, int width) {
        return (int) Math.max(0, Math.min(width, Math.ceil(x)));
    }

    private static final class Walk implements SpanWalk {
        private final ScanlineEdges edges;
        private final FillRule rule;
        private final int left;
        private final int right;

        /** The first column of the row whose edge functions are not known. */
        private int next;

        private int from;
        private int to;
        private long evaluated;

        Walk(ScanlineEdges edges, FillRule rule, int left, int right) {
            this.edges = edges;
            this.rule = rule;
            this.left = left;
            this.right = right;
            next = right;
        }

        @Override
        public boolean advance() {
            while (next < right || nextRow()) {
                while (next < right && !inside(next)) next++;
                if (next == right) continue;
                from = next++;
                while (next < right && inside(next)) next++;
                to = next;
                if (next < right) next++; // it ended the span, so it is known to be outside
                return true;
            }
            return false;
        }

        private boolean nextRow() {
            if (!edges.nextRow()) return false;
            next = left;
            return true;
        }

        private boolean inside(int column) {
            int winding = 0;
            for (int i = 0; i < edges.size(); i++) {
                PolygonEdge edge = edges.edge(i);
                if (edge.reaches(column, edges.row())) winding += edge.winding();
            }
            evaluated += edges.size();
            return rule.inside(winding);
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
            return edges.size();
        }

        @Override
        public Map<String, Long> operations() {
            return Map.of("edge functions", evaluated);
        }
    }
}
