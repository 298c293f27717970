package rasterlab.tests.bench;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import rasterlab.engine.line.RasterLine;
import rasterlab.engine.raster.Raster;

/**
 * Segments across the edges of a picture of 512×512 pixels: each has one end outside or both.
 *
 * <p>Both light the same pixels, as in {@link LineBenchmark}.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class ClippedLineBenchmark {
    static final List<Goal> GOALS =
            List.of(
                    goal("clipped segments of 64 px", "64", 4.5),
                    goal("clipped segments of 4000 px", "4000", 1.3));

    private static final int SIZE = 512;
    private static final int SEGMENTS = 256;

    @Param({"64", "4000"})
    public int pixels;

    private final int[] ends = new int[4 * SEGMENTS];
    private Raster raster;
    private Raster peerRaster;
    private Graphics2D graphics;

    private static Goal goal(String work, String pixels, double ratio) {
        return new Goal(
                work,
                ClippedLineBenchmark.class,
                "intoThePicture",
                "graphics2d",
                Map.of("pixels", pixels),
                ratio);
    }

    @Setup
    public void prepare() {
        var random = new Random(1965);
        int i = 0;
        while (i < SEGMENTS) {
            int side = random.nextInt(4);
            int at = random.nextInt(SIZE);
            int x = side == 0 ? 0 : side == 1 ? SIZE - 1 : at;
            int y = side == 2 ? 0 : side == 3 ? SIZE - 1 : at;
            double angle = random.nextDouble() * 2 * Math.PI;
            double longer = Math.max(Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle)));
            int dx = (int) Math.round((pixels - 1) * Math.cos(angle) / longer);
            int dy = (int) Math.round((pixels - 1) * Math.sin(angle) / longer);
            int x0 = x - dx / 2;
            int y0 = y - dy / 2;
            if (isInside(x0, y0) && isInside(x0 + dx, y0 + dy)) continue;
            ends[4 * i] = x0;
            ends[4 * i + 1] = y0;
            ends[4 * i + 2] = x0 + dx;
            ends[4 * i + 3] = y0 + dy;
            i++;
        }
        raster = new Raster(SIZE, SIZE);
        peerRaster = new Raster(SIZE, SIZE);
        graphics = peerRaster.image().createGraphics();
        graphics.setColor(Color.WHITE);
    }

    private static boolean isInside(int x, int y) {
        return x >= 0 && y >= 0 && x < SIZE && y < SIZE;
    }

    /** How many pixels only one of the two lights, segment by segment. */
    long different() {
        return SegmentDifference.count(ends, raster, peerRaster, graphics);
    }

    /** Segments with both ends in the picture. */
    int inside() {
        int inside = 0;
        for (int i = 0; i < ends.length; i += 4)
            if (isInside(ends[i], ends[i + 1]) && isInside(ends[i + 2], ends[i + 3])) inside++;
        return inside;
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public Raster intoThePicture() {
        for (int i = 0; i < ends.length; i += 4)
            RasterLine.draw(ends[i], ends[i + 1], ends[i + 2], ends[i + 3], -1, raster);
        return raster;
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public Graphics2D graphics2d() {
        for (int i = 0; i < ends.length; i += 4)
            graphics.drawLine(ends[i], ends[i + 1], ends[i + 2], ends[i + 3]);
        return graphics;
    }
}
