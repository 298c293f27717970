package rasterlab.tests.bench;

import java.awt.Color;
import java.awt.Graphics2D;
import java.util.Arrays;
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
import rasterlab.contract.FillRule;
import rasterlab.contract.Spans;
import rasterlab.engine.polygon.scan.ScanlinePolygon;
import rasterlab.engine.raster.Raster;

/**
 * Polygons in boxes of one size somewhere in a picture of 512×512 pixels.
 *
 * <p>Graphics2D has its pixel centres halfway between the whole coordinates and moves every corner
 * by a quarter of a pixel first, so ours get every corner a quarter of a pixel less: then both fill
 * the same pixels, but for a few at the edges where the peer's rounding decides.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class PolygonBenchmark {
    static final List<Goal> GOALS =
            List.of(
                    goal("flat triangles of 10 px", "3 in 10", 8),
                    goal("flat triangles of 50 px", "3 in 50", 2.5),
                    goal("flat triangles of 200 px", "3 in 200", 1.5),
                    goal("polygons of 20 corners", "20 in 200", 1.6),
                    goal("polygons of 200 corners", "200 in 400", 1.3));

    private static final int SIZE = 512;
    private static final int POLYGONS = 256;

    /** Corners, and side of the box in pixels. */
    @Param({"3 in 10", "3 in 50", "3 in 200", "20 in 200", "200 in 400"})
    public String shape;

    private final ScanlinePolygon polygons = new ScanlinePolygon();
    private Spans spans;
    private int corners;
    private int[][] x;
    private int[][] y;
    private double[][] ourX;
    private double[][] ourY;
    private Raster raster;
    private Raster peerRaster;
    private Graphics2D graphics;

    private static Goal goal(String work, String shape, double ratio) {
        return new Goal(
                work,
                PolygonBenchmark.class,
                "intoThePicture",
                "graphics2d",
                Map.of("shape", shape),
                ratio);
    }

    @Setup
    public void prepare() {
        String[] words = shape.split(" in ");
        corners = Integer.parseInt(words[0]);
        int side = Integer.parseInt(words[1]);
        var random = new Random(1967);
        x = new int[POLYGONS][corners];
        y = new int[POLYGONS][corners];
        ourX = new double[POLYGONS][corners];
        ourY = new double[POLYGONS][corners];
        for (int i = 0; i < POLYGONS; i++) place(i, side, random);
        raster = new Raster(SIZE, SIZE);
        int[] cells = raster.argb();
        spans = (row, from, to) -> Arrays.fill(cells, row * SIZE + from, row * SIZE + to, -1);
        peerRaster = new Raster(SIZE, SIZE);
        graphics = peerRaster.image().createGraphics();
        graphics.setColor(Color.WHITE);
    }

    /** Triangles have corners anywhere in the box, others are jagged stars about its middle. */
    private void place(int i, int side, Random random) {
        int left = random.nextInt(SIZE - side);
        int top = random.nextInt(SIZE - side);
        for (int k = 0; k < corners; k++) {
            double angle = 2 * Math.PI * k / corners;
            double distance = side / 2.0 * (0.4 + 0.6 * random.nextDouble());
            boolean star = corners > 3;
            double u = star ? side / 2.0 + distance * Math.cos(angle) : random.nextInt(side + 1);
            double v = star ? side / 2.0 + distance * Math.sin(angle) : random.nextInt(side + 1);
            x[i][k] = left + (int) Math.round(u);
            y[i][k] = top + (int) Math.round(v);
            ourX[i][k] = x[i][k] - 0.25;
            ourY[i][k] = y[i][k] - 0.25;
        }
    }

    @Benchmark
    @OperationsPerInvocation(POLYGONS)
    public Raster intoThePicture() {
        for (int i = 0; i < POLYGONS; i++)
            polygons.fill(ourX[i], ourY[i], FillRule.EVEN_ODD, SIZE, SIZE, spans);
        return raster;
    }

    @Benchmark
    @OperationsPerInvocation(POLYGONS)
    public Graphics2D graphics2d() {
        for (int i = 0; i < POLYGONS; i++) graphics.fillPolygon(x[i], y[i], corners);
        return graphics;
    }

    /**
     * The share of pixels that only one of the two fills, polygon by polygon, among those that ours
     * fills.
     */
    double different() {
        long different = 0;
        long filled = 0;
        for (int i = 0; i < POLYGONS; i++) {
            raster.clear(0);
            peerRaster.clear(0);
            polygons.fill(ourX[i], ourY[i], FillRule.EVEN_ODD, SIZE, SIZE, spans);
            graphics.fillPolygon(x[i], y[i], corners);
            for (int cell = 0; cell < SIZE * SIZE; cell++) {
                if (raster.argb()[cell] != 0) filled++;
                if (raster.argb()[cell] != peerRaster.argb()[cell]) different++;
            }
        }
        return (double) different / filled;
    }
}
