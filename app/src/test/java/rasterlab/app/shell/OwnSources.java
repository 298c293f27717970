package rasterlab.app.shell;

/** Programs of students for exercises that keep no model solution. */
final class OwnSources {
    /**
     * A source that is right where no coordinate is huge: this exercise is measured against its
     * topic's method.
     */
    static final String SEGMENTS =
            """
            public class Mine implements rasterlab.contract.SegmentClipper {
                public void clip(double l, double b, double r, double t, double x, double y,
                        double u, double v, rasterlab.contract.SegmentSink out) {
                    double[] p = {x - u, u - x, y - v, v - y}, q = {x - l, r - x, y - b, t - y};
                    double[] ends = {0, 1};
                    for (int i = 0; i < 4; i++)
                        if (p[i] < 0) ends[0] = Math.max(ends[0], q[i] / p[i]);
                        else if (p[i] > 0) ends[1] = Math.min(ends[1], q[i] / p[i]);
                        else if (q[i] < 0) return;
                    double from = ends[0], to = ends[1], dx = u - x, dy = v - y;
                    if (from <= to)
                        out.segment(x + from * dx, y + from * dy, x + to * dx, y + to * dy);
                }
            }
            """;

    private OwnSources() {}
}
