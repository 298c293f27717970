package rasterlab.tests.bench;

import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;
import rasterlab.engine.clip.segment.BranchlessLiangBarsky;
import rasterlab.engine.clip.segment.CohenSutherland;

/**
 * Segments with both ends anywhere in the nine regions, each region as large as the window; the
 * peer only tells whether a segment meets the window, ours compute what is left of it.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class ClipBenchmark {
    static final List<Goal> GOALS =
            List.of(
                    goal("Cohen–Sutherland", "cohenSutherland", 0.9),
                    goal("Liang–Barsky", "liangBarsky", 2.5));

    /** A number of segments above what a processor can learn the branches of by heart. */
    private static final int SEGMENTS = 1 << 16;

    private static final double SIZE = 100;

    private final double[] ends = new double[4 * SEGMENTS];
    private final Rectangle2D.Double window = new Rectangle2D.Double(0, 0, SIZE, SIZE);
    private final SegmentClipper cohenSutherland = new CohenSutherland();
    private final SegmentClipper liangBarsky = new BranchlessLiangBarsky();
    private double sum;

    private static Goal goal(String name, String method, double ratio) {
        return new Goal(
                "clipping segments, " + name,
                ClipBenchmark.class,
                method,
                "intersectsLine",
                Map.of(),
                ratio);
    }

    /** Draws the ends, and makes sure that ours and the peer judge all segments alike. */
    @Setup
    public void prepare() {
        var random = new Random(1967);
        for (int i = 0; i < ends.length; i++) ends[i] = (3 * random.nextDouble() - 1) * SIZE;
        int met = intersectsLine();
        for (SegmentClipper method : List.of(cohenSutherland, liangBarsky)) {
            var kept = new int[1];
            clipAll(method, (x0, y0, x1, y1) -> kept[0]++);
            if (kept[0] != met)
                throw new IllegalStateException(
                        method.getClass() + " keeps " + kept[0] + " segments, the peer " + met);
        }
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public double cohenSutherland() {
        clipAll(cohenSutherland, (x0, y0, x1, y1) -> sum += x0 + y0 + x1 + y1);
        return sum;
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public double liangBarsky() {
        clipAll(liangBarsky, (x0, y0, x1, y1) -> sum += x0 + y0 + x1 + y1);
        return sum;
    }

    private void clipAll(SegmentClipper method, SegmentSink out) {
        for (int i = 0; i < ends.length; i += 4)
            method.clip(0, 0, SIZE, SIZE, ends[i], ends[i + 1], ends[i + 2], ends[i + 3], out);
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public int intersectsLine() {
        int met = 0;
        for (int i = 0; i < ends.length; i += 4)
            if (window.intersectsLine(ends[i], ends[i + 1], ends[i + 2], ends[i + 3])) met++;
        return met;
    }
}
