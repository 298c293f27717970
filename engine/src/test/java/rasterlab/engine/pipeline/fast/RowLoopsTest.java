package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Tag;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.EightLanes;
import rasterlab.engine.scene.VertexQuantity;

/** Each loop of eight lanes beside the plain one, bit for bit. */
@Tag("slow")
class RowLoopsTest {
    private static final int WIDTH = 40;

    private RowLoops eight;
    private final RowLoops one = RowLoops.of(Lanes.ONE);
    private Random random;
    private int seed;

    @BeforeEach
    void needEight(RepetitionInfo repetition) {
        EightLanes.assumeThere();
        eight = RowLoops.of(Lanes.EIGHT);
        seed = repetition.getCurrentRepetition();
        random = new Random(seed);
    }

    private static PixelBatch batch(RowLoops loops) {
        var batch = new PixelBatch(loops);
        batch.begin(
                new PixelColors() {
                    @Override
                    public Set<VertexQuantity> wants() {
                        return Set.of(
                                VertexQuantity.RED, VertexQuantity.GREEN, VertexQuantity.BLUE);
                    }

                    @Override
                    public void color(PixelBatch pixels) {}
                });
        return batch;
    }

    private float[] shares(int count) {
        float[] shares = new float[count];
        for (int i = 0; i < count; i++) shares[i] = random.nextFloat();
        return shares;
    }

    /**
     * Triangles whose lowest row ends at the band's end or some pixels before it, all of them or
     * some pixels nearer; some fill a batch.
     */
    @RepeatedTest(40)
    void collectTheSamePixelsUpToTheBandsEnd() {
        for (int after = 0; after < 20; after++) {
            String what = "seed %d, %d pixels after".formatted(seed, after);
            boolean early = random.nextBoolean();
            float[] depth = shares(WIDTH * TriangleScan.ROWS);
            if (random.nextBoolean()) Arrays.fill(depth, random.nextInt(2));
            float[] depthOfOne = depth.clone();
            var v = corner(WIDTH - after);
            var scan = new TriangleScan();
            scan.load(v, 0, 1, 2, Bands.of(new DepthRaster(WIDTH, TriangleScan.ROWS), 0));
            scan.scan();
            int waiting = random.nextInt(PixelBatch.SIZE);
            assertEquals(
                    collected(one, depthOfOne, scan, v, early, waiting),
                    collected(eight, depth, scan, v, early, waiting),
                    what);
            assertArrayEquals(depthOfOne, depth, what);
        }
    }

    private record Pixel(int cell, float weightB, float weightC, float depth) {}

    /**
     * @param waiting pixels of others in the first batch
     */
    private static List<Pixel> collected(
            RowLoops loops,
            float[] depth,
            TriangleScan scan,
            ScreenVertices v,
            boolean early,
            int waiting) {
        var pixels = new ArrayList<Pixel>();
        var batch = batch(loops);
        var weights = new RowWeights();
        weights.load(scan, v);
        for (int first = waiting; weights.row < scan.rows; first = 0) {
            batch.count = first;
            int row = weights.row;
            int done = weights.done;
            loops.collect(depth, 0, scan, weights, early, batch);
            boolean further = weights.row > row || weights.done > done;
            assertTrue(first > 0 || further, "an empty batch takes nothing");
            pixels.addAll(pixels(batch, first, early));
        }
        return pixels;
    }

    private static List<Pixel> pixels(PixelBatch batch, int first, boolean early) {
        var pixels = new ArrayList<Pixel>();
        for (int i = first; i < batch.count; i++)
            pixels.add(
                    new Pixel(
                            batch.cell[i],
                            batch.weightB[i],
                            batch.weightC[i],
                            early ? 0 : batch.depth[i]));
        return pixels;
    }

    /** What is found in boxes is what rows have; which triangles are sought so is counted. */
    @RepeatedTest(40)
    void findTheSamePixelsInBoxes() {
        float[] depth = shares(WIDTH * TriangleScan.ROWS);
        float[] depthOfOne = depth.clone();
        var scan = new TriangleScan();
        var weights = new RowWeights();
        Band band = Bands.of(new DepthRaster(WIDTH, TriangleScan.ROWS), 0);
        int sought = 0;
        for (int round = 0; round < 200; round++) {
            var v = triangle(WIDTH, TriangleScan.ROWS, RowDepth.WIDEST, TriangleScan.ROWS);
            scan.load(v, 0, 1, 2, band);
            if (scan.rows <= 0 || scan.boxLeft >= scan.boxRight) continue;
            weights.load(scan, v);
            int found = eight.findInBox(depth, 0, WIDTH, scan, weights.depth);
            if (found == RowLoops.NOT_SOUGHT) continue;
            sought++;
            var actual = batch(eight);
            int waiting = actual.count = random.nextInt(PixelBatch.SIZE - found + 1);
            eight.addFound(WIDTH, scan, weights, actual);
            assertEquals(found, actual.count - waiting, "seed %d, round %d".formatted(seed, round));
            scan.scan();
            var ofRows = collected(one, depthOfOne, scan, v, true, 0);
            assertEquals(
                    Set.copyOf(ofRows),
                    Set.copyOf(pixels(actual, waiting, true)),
                    "seed %d, round %d".formatted(seed, round));
        }
        assertTrue(sought > 20, sought + " triangles of seed " + seed);
        assertArrayEquals(depthOfOne, depth, "seed " + seed);
    }

    /** Small triangles across the picture's sides and the band's, nearer than some pixels. */
    @RepeatedTest(40)
    void collectTheSamePixelsOfSmallTriangles() {
        float[] depth = shares(WIDTH * TriangleScan.ROWS);
        float[] depthOfOne = depth.clone();
        var tiny = new TinyScan();
        Band band = Bands.of(new DepthRaster(WIDTH, TriangleScan.ROWS), 0);
        for (int round = 0; round < 200; round++) {
            boolean early = random.nextInt(4) > 0;
            var v = triangle(WIDTH, TriangleScan.ROWS, TinyScan.SIDE, TinyScan.SIDE);
            if (!tiny.load(v, 0, 1, 2, band)) continue;
            var expected = batch(one);
            var actual = batch(eight);
            int waiting = random.nextInt(PixelBatch.SIZE - TinyScan.MOST + 1);
            expected.count = actual.count = waiting;
            one.collect(depthOfOne, 0, WIDTH, tiny, v, early, expected);
            eight.collect(depth, 0, WIDTH, tiny, v, early, actual);
            assertEquals(
                    pixels(expected, waiting, early),
                    pixels(actual, waiting, early),
                    "seed %d, round %d".formatted(seed, round));
        }
        assertArrayEquals(depthOfOne, depth, "seed " + seed);
    }

    /** Triangles whose lowest rows end at the picture's end, which is the band's. */
    @RepeatedTest(40)
    void drawTheSameRowsUpToTheBandsEnd() {
        for (int after = 0; after < 20; after++) {
            var expected = new DepthRaster(WIDTH, TriangleScan.ROWS);
            var actual = new DepthRaster(WIDTH, TriangleScan.ROWS);
            var v = corner(WIDTH - after);
            var scan = new TriangleScan();
            scan.load(v, 0, 1, 2, Bands.of(expected, 0));
            scan.scan();
            var colors = new LinearColors();
            colors.load(scan, v);
            eight.linear(Bands.of(actual, 0), scan, colors);
            one.linear(Bands.of(expected, 0), scan, colors);
            EightLanes.assertSame(expected, actual, "seed %d, %d after".formatted(seed, after));
        }
    }

    /** Small triangles in a narrow picture, across its sides and across two bands. */
    @RepeatedTest(40)
    void drawTheSameSmallTriangles() {
        var expected = new DepthRaster(WIDTH, 2 * TriangleScan.ROWS);
        var actual = new DepthRaster(WIDTH, 2 * TriangleScan.ROWS);
        var tiny = new TinyScan();
        for (int round = 0; round < 200; round++) {
            var v = triangle(WIDTH, 2 * TriangleScan.ROWS, TinyScan.SIDE, TinyScan.SIDE);
            for (int top : new int[] {0, TriangleScan.ROWS}) {
                Band band = Bands.of(expected, top);
                if (!tiny.load(v, 0, 1, 2, band)) continue;
                one.smooth(band, tiny, v);
                eight.smooth(Bands.of(actual, top), tiny, v);
            }
        }
        EightLanes.assertSame(expected, actual, "seed %d".formatted(seed));
    }

    /** Colours leave 0 to 255 on corners whose 1/w is far smaller than another's. */
    @RepeatedTest(40)
    void drawTheSameColorsBeyondTheirRange() {
        var expected = new DepthRaster(WIDTH, TriangleScan.ROWS);
        var actual = new DepthRaster(WIDTH, TriangleScan.ROWS);
        Band band = Bands.of(expected, 0);
        var tiny = new TinyScan();
        for (int round = 0; round < 1000; round++) {
            var v = new ScreenVertices();
            v.begin(3, 3);
            int left = random.nextInt(WIDTH);
            int top = random.nextInt(TriangleScan.ROWS);
            for (int k = 0; k < 3; k++) {
                int x = left + random.nextInt(TinyScan.SIDE) << Subpixels.BITS;
                int y = top + random.nextInt(TinyScan.SIDE) << Subpixels.BITS;
                float nearness = (float) Math.pow(10, -12 * random.nextDouble());
                v.put(k, x, y, random.nextFloat(), nearness);
            }
            if (!tiny.load(colored(v), 0, 1, 2, band)) continue;
            one.smooth(band, tiny, v);
            eight.smooth(Bands.of(actual, 0), tiny, v);
        }
        EightLanes.assertSame(expected, actual, "seed %d".formatted(seed));
    }

    /** Narrow triangles of every height, up to where their edge functions are no ints. */
    @RepeatedTest(40)
    void drawTheSameNarrowTriangles() {
        int height = 4096;
        var expected = new DepthRaster(WIDTH, height);
        var actual = new DepthRaster(WIDTH, height);
        var scan = new TriangleScan();
        var colors = new LinearColors();
        int compact = 0;
        for (int round = 0; round < 400; round++) {
            int tall = 1 << random.nextInt(13);
            var v = triangle(WIDTH, height, RowDepth.WIDEST, tall);
            int middle = v.y(0) / Subpixels.ONE / TriangleScan.ROWS * TriangleScan.ROWS;
            if (middle < 0 || middle >= height) continue;
            Band band = Bands.of(expected, middle);
            scan.load(v, 0, 1, 2, band);
            if (scan.rows <= 0 || scan.boxLeft >= scan.boxRight) continue;
            colors.load(scan, v);
            if (colors.depth.compact) compact++;
            eight.linear(Bands.of(actual, middle), scan, colors);
            one.linear(band, scan, colors);
        }
        assertTrue(compact > 20, compact + " compact triangles of seed " + seed);
        EightLanes.assertSame(expected, actual, "seed %d".formatted(seed));
    }

    /** Where a picture cuts a box off, its triangle's edge functions are large all over it. */
    @RepeatedTest(40)
    void drawTheSameTrianglesThatReachFarOut() {
        var expected = new DepthRaster(WIDTH, TriangleScan.ROWS);
        var actual = new DepthRaster(WIDTH, TriangleScan.ROWS);
        Band band = Bands.of(expected, 0);
        var scan = new TriangleScan();
        var colors = new LinearColors();
        int compact = 0;
        for (int round = 0; round < 2000; round++) {
            boolean leftward = random.nextBoolean();
            var v = new ScreenVertices();
            v.begin(3, 3);
            for (int k = 0; k < 3; k++) {
                int out = 1 << random.nextInt(14);
                int x = leftward ? RowDepth.WIDEST - out : WIDTH - RowDepth.WIDEST + out;
                int tall = random.nextInt(1 << random.nextInt(14));
                int y = random.nextBoolean() ? TriangleScan.ROWS + tall : -tall;
                int fine = random.nextInt(Subpixels.ONE);
                v.put(k, x * Subpixels.ONE, y * Subpixels.ONE + fine, random.nextFloat(), 1);
            }
            scan.load(colored(v), 0, 1, 2, band);
            if (scan.rows <= 0 || scan.boxLeft >= scan.boxRight) continue;
            colors.load(scan, v);
            if (colors.depth.compact) compact++;
            eight.linear(Bands.of(actual, 0), scan, colors);
            one.linear(band, scan, colors);
        }
        assertTrue(compact > 20, compact + " compact triangles of seed " + seed);
        EightLanes.assertSame(expected, actual, "seed %d".formatted(seed));
    }

    /** Where depths are equal nothing is drawn twice. */
    @RepeatedTest(40)
    void drawAFewPixelsAsTheOthers() {
        var expected = new DepthRaster(WIDTH, TriangleScan.ROWS);
        var actual = new DepthRaster(WIDTH, TriangleScan.ROWS);
        expected.raster().clear(0xFF000000);
        actual.raster().clear(0xFF000000);
        Band band = Bands.of(expected, 0);
        var scan = new TinyScan();
        for (int round = 0; round < 2000; round++) {
            var v = triangle(WIDTH, TriangleScan.ROWS, 4, 4);
            if (!scan.load(v, 0, 1, 2, band) || scan.rows <= 0 || scan.columns <= 0) continue;
            one.smooth(band, scan, v);
            TinyFill.few(Bands.of(actual, 0), scan, v);
        }
        EightLanes.assertSame(expected, actual, "seed %d".formatted(seed));
    }

    /** Corners within so many pixels, the first of them in the picture or beside it. */
    private ScreenVertices triangle(int width, int height, int columns, int rows) {
        var v = new ScreenVertices();
        v.begin(3, 3);
        int left = random.nextInt(width + columns) - columns;
        int top = random.nextInt(height + rows) - rows;
        for (int k = 0; k < 3; k++) {
            int x = left * Subpixels.ONE + random.nextInt(columns * Subpixels.ONE);
            int y = top * Subpixels.ONE + random.nextInt(rows * Subpixels.ONE);
            v.put(k, x, y, random.nextFloat(), 0.5f + random.nextFloat());
        }
        return colored(v);
    }

    /** A triangle with a right angle in the band's last row, left of a column. */
    private ScreenVertices corner(int right) {
        var v = new ScreenVertices();
        v.begin(3, 3);
        int x = right * Subpixels.ONE;
        int bottom = TriangleScan.ROWS * Subpixels.ONE;
        v.put(0, x, -random.nextInt(9) * Subpixels.ONE, random.nextFloat(), 0);
        v.put(1, x, bottom, random.nextFloat(), 0);
        int left = (right - 1 - random.nextInt(right)) * Subpixels.ONE;
        v.put(2, left, bottom, random.nextFloat(), 0);
        return colored(v);
    }

    private ScreenVertices colored(ScreenVertices v) {
        for (int vertex = 0; vertex < 3; vertex++)
            for (int k = 0; k < 3; k++) v.putAttribute(k, vertex, random.nextInt(256));
        return v;
    }

    @RepeatedTest(40)
    void interpolateAndPackTheSameNumbers() {
        var expected = batch(one);
        var actual = batch(eight);
        int first = random.nextInt(20);
        expected.count = actual.count = first + random.nextInt(PixelBatch.SIZE - first + 1);
        float[] b = shares(PixelBatch.ROOM);
        float[] c = shares(PixelBatch.ROOM);
        for (var each : new PixelBatch[] {expected, actual}) {
            System.arraycopy(b, 0, each.weightB, 0, b.length);
            System.arraycopy(c, 0, each.weightC, 0, c.length);
        }
        float[] corners = shares(3 * RowLoops.VALUES);
        for (int k = 0; k < corners.length; k++) corners[k] /= 3;
        int growing = random.nextInt(4);
        float[][] expectedRgb = rgb(one, expected, first, corners, growing);
        float[][] actualRgb = rgb(eight, actual, first, corners, growing);
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < expected.count; i++)
                assertEquals(
                        expectedRgb[k][i],
                        actualRgb[k][i],
                        "seed %d, channel %d, pixel %d".formatted(seed, k, i));
        expected.pack(expectedRgb[0], expectedRgb[1], expectedRgb[2]);
        actual.pack(actualRgb[0], actualRgb[1], actualRgb[2]);
        assertArrayEquals(
                Arrays.copyOf(expected.argb, expected.count),
                Arrays.copyOf(actual.argb, expected.count),
                "seed " + seed);
    }

    /** Some channels between the corners, each of the others one number. */
    private static float[][] rgb(
            RowLoops loops, PixelBatch batch, int first, float[] corners, int growing) {
        float[][] rgb = {
            batch.values(VertexQuantity.RED),
            batch.values(VertexQuantity.GREEN),
            batch.values(VertexQuantity.BLUE)
        };
        loops.between(batch, rgb, corners, growing, first);
        for (int k = growing; k < 3; k++) Arrays.fill(rgb[k], first, batch.count, corners[k]);
        return rgb;
    }
}
