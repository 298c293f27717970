package rasterlab.tests.bench;

import java.awt.geom.CubicCurve2D;
import java.awt.geom.FlatteningPathIterator;
import java.awt.geom.PathIterator;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import rasterlab.contract.Curve;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.curve.AdaptiveCurve;
import rasterlab.engine.spline.curve.FewestCurve;
import rasterlab.tests.bench.language.BenchWords;

/**
 * Segments for random cubic Bézier curves, 0.25 pixels off at most, by our methods and others.
 *
 * @param box pixels of the square that the control points lie in, at least 1
 * @param least possible where corners lie on the curve, by search
 * @param jdk those of {@link FlatteningPathIterator}
 */
record SegmentCounts(int box, int least, int fewest, int adaptive, int jdk) {
    static final long SEED = 33;

    /** The most segments beside the least possible, and beside the JDK's. */
    static final double FEWEST = 1.1;

    static final double ADAPTIVE = 1;

    private static final List<Integer> BOXES = List.of(20, 200, 1000);
    static final int CURVES = 256;
    private static final double FLATNESS = 0.25;

    SegmentCounts {
        if (box < 1) throw new IllegalArgumentException("box must be at least 1, got " + box);
    }

    static SegmentCounts of(int box) {
        var random = new Random(SEED);
        int least = 0;
        int fewest = 0;
        int adaptive = 0;
        int jdk = 0;
        for (int i = 0; i < CURVES; i++) {
            double[] x = random.doubles(4, 0, box).toArray();
            double[] y = random.doubles(4, 0, box).toArray();
            least += LeastChords.of(x, y, FLATNESS);
            fewest += segments(new FewestCurve(), x, y);
            adaptive += segments(new AdaptiveCurve(), x, y);
            jdk += segments(x, y);
        }
        return new SegmentCounts(box, least, fewest, adaptive, jdk);
    }

    private static int segments(CurveTracer method, double[] x, double[] y) {
        var corners = new int[1];
        method.flatten(new Curve(Curve.Kind.BEZIER, x, y), FLATNESS, (px, py) -> corners[0]++);
        return corners[0] - 1;
    }

    private static int segments(double[] x, double[] y) {
        var curve = new CubicCurve2D.Double(x[0], y[0], x[1], y[1], x[2], y[2], x[3], y[3]);
        PathIterator path = new FlatteningPathIterator(curve.getPathIterator(null), FLATNESS);
        int corners = 0;
        for (; !path.isDone(); path.next()) corners++;
        return corners - 1;
    }

    /**
     * Writes two lines for each size of curves: ours, the other's, the ratio and the most of it.
     */
    static void print(BenchWords words, PrintStream out) {
        out.println(words.head("head.segments"));
        for (int box : BOXES) {
            SegmentCounts counts = of(box);
            out.println(counts.line("fewest", counts.fewest, "least", counts.least, FEWEST, words));
            out.println(
                    counts.line(
                            "adaptive",
                            counts.adaptive,
                            "flatteningPathIterator",
                            counts.jdk,
                            ADAPTIVE,
                            words));
        }
    }

    private String line(
            String name, int ours, String peer, int theirs, double most, BenchWords words) {
        double ratio = (double) ours / theirs;
        return String.format(
                Locale.ROOT,
                "Bézier curves of %d px, %s | %s %.1f | %s %.1f | %.3f | %.2f | %s",
                box,
                name,
                name,
                (double) ours / CURVES,
                peer,
                (double) theirs / CURVES,
                ratio,
                most,
                words.text(ratio <= most ? "yes" : "no"));
    }
}
