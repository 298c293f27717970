package rasterlab.tests.bench;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
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
import rasterlab.contract.CoveragePixels;
import rasterlab.engine.line.RasterLine;
import rasterlab.engine.line.WuLine;
import rasterlab.engine.raster.Raster;

/**
 * Segments of one length in all directions, wholly inside a picture of 1280×1280 pixels.
 *
 * <p>Both light the same pixels: the number of steps is odd, so no exact line passes midway between
 * two pixels, where ours takes the smaller coordinate and the peer goes by a rule of its own.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class LineBenchmark {
    static final List<Goal> GOALS =
            List.of(
                    goal("segments of 16 px", "intoThePicture", "graphics2d", 16, 5),
                    goal("segments of 128 px", "intoThePicture", "graphics2d", 128, 2.2),
                    goal("segments of 1000 px", "intoThePicture", "graphics2d", 1000, 1.2),
                    goal("anti-aliased segments of 16 px", "shaded", "graphics2dShaded", 16, 12),
                    goal("anti-aliased segments of 128 px", "shaded", "graphics2dShaded", 128, 10),
                    goal(
                            "anti-aliased segments of 1000 px",
                            "shaded",
                            "graphics2dShaded",
                            1000,
                            9));

    private static final int SIZE = 1280;
    private static final int SEGMENTS = 256;

    @Param({"16", "128", "1000"})
    public int pixels;

    private final int[] ends = new int[4 * SEGMENTS];
    private final WuLine wu = new WuLine();
    private Raster raster;
    private CoveragePixels shades;
    private Raster peerRaster;
    private Graphics2D graphics;
    private Graphics2D shadingGraphics;

    private static Goal goal(String work, String ours, String peer, int pixels, double ratio) {
        return new Goal(
                work,
                LineBenchmark.class,
                ours,
                peer,
                Map.of("pixels", String.valueOf(pixels)),
                ratio);
    }

    @Setup
    public void prepare() {
        var random = new Random(1965);
        for (int i = 0; i < SEGMENTS; i++) {
            double angle = random.nextDouble() * 2 * Math.PI;
            double longer = Math.max(Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle)));
            int dx = (int) Math.round((pixels - 1) * Math.cos(angle) / longer);
            int dy = (int) Math.round((pixels - 1) * Math.sin(angle) / longer);
            ends[4 * i] = Math.max(0, -dx) + random.nextInt(SIZE - Math.abs(dx));
            ends[4 * i + 1] = Math.max(0, -dy) + random.nextInt(SIZE - Math.abs(dy));
            ends[4 * i + 2] = ends[4 * i] + dx;
            ends[4 * i + 3] = ends[4 * i + 1] + dy;
        }
        raster = picture();
        int[] cells = raster.argb();
        shades = (x, y, level) -> cells[y * SIZE + x] = 0xFF000000 | level * 0x010101;
        peerRaster = picture();
        graphics = graphics(peerRaster, RenderingHints.VALUE_ANTIALIAS_OFF);
        shadingGraphics = graphics(picture(), RenderingHints.VALUE_ANTIALIAS_ON);
    }

    private static Raster picture() {
        var picture = new Raster(SIZE, SIZE);
        picture.clear(0xFF000000);
        return picture;
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public Raster intoThePicture() {
        for (int i = 0; i < ends.length; i += 4)
            RasterLine.draw(ends[i], ends[i + 1], ends[i + 2], ends[i + 3], -1, raster);
        return raster;
    }

    private static Graphics2D graphics(Raster picture, Object antialiasing) {
        Graphics2D graphics = picture.image().createGraphics();
        graphics.setColor(Color.WHITE);
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, antialiasing);
        return graphics;
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public Raster shaded() {
        for (int i = 0; i < ends.length; i += 4)
            wu.shade(ends[i], ends[i + 1], ends[i + 2], ends[i + 3], shades);
        return raster;
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public Graphics2D graphics2dShaded() {
        for (int i = 0; i < ends.length; i += 4)
            shadingGraphics.drawLine(ends[i], ends[i + 1], ends[i + 2], ends[i + 3]);
        return shadingGraphics;
    }

    @Benchmark
    @OperationsPerInvocation(SEGMENTS)
    public Graphics2D graphics2d() {
        for (int i = 0; i < ends.length; i += 4)
            graphics.drawLine(ends[i], ends[i + 1], ends[i + 2], ends[i + 3]);
        return graphics;
    }

    /** How many pixels only one of the two lights, segment by segment. */
    long different() {
        return SegmentDifference.count(ends, raster, peerRaster, graphics);
    }
}
