package rasterlab.engine.pipeline.triangle;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.EightLanes;

/** The triangles of a block beside the same ones found one by one, bit for bit. */
class TinyBlockTest {
    private static final int TRIANGLES = 2000;
    private static final int WIDTH = 40;
    private static final int TOP = TriangleScan.ROWS;

    private final TinyBlock block = new TinyBlock();
    private final ScreenVertices mesh = new ScreenVertices();
    private final TriangleChunk chunk = new TriangleChunk();
    private final TinyScan expected = new TinyScan();
    private final Band band = Bands.of(new DepthRaster(WIDTH, 2 * TriangleScan.ROWS), TOP);
    private RowLoops eight;
    private Random random;
    private String seed;

    @BeforeEach
    void placeTriangles(RepetitionInfo repetition) {
        EightLanes.assumeThere();
        eight = RowLoops.of(Lanes.EIGHT);
        seed = "seed " + repetition.getCurrentRepetition();
        random = new Random(repetition.getCurrentRepetition());
        mesh.begin(3 * TRIANGLES, 0);
        chunk.begin(1, 0);
        chunk.clipped.ensure(3 * TRIANGLES);
        chunk.corners = new int[3 * TRIANGLES];
        boolean made = false;
        for (int t = 0; t < TRIANGLES; t++) {
            if (random.nextInt(40) == 0) made = !made;
            place(made ? chunk.clipped : mesh, 3 * t);
            for (int v = 3 * t; v < 3 * t + 3; v++) chunk.corners[v] = made ? ~v : v;
        }
    }

    /** In the band and the picture or across their ends, some large, some on whole pixels. */
    private void place(ScreenVertices v, int first) {
        int reach = 1 << random.nextInt(random.nextInt(10) == 0 ? 14 : 4);
        int step = random.nextInt(3) == 0 ? Subpixels.ONE : 1;
        do {
            int x = random.nextInt(WIDTH * Subpixels.ONE);
            int y = (TOP + random.nextInt(TriangleScan.ROWS)) * Subpixels.ONE;
            for (int k = first; k < first + 3; k++)
                v.put(k, near(x, reach, step), near(y, reach, step), 0, 0);
        } while (twiceArea(v, first) == 0 || isBeside(v, first));
    }

    private int near(int middle, int reach, int step) {
        int steps = reach * Subpixels.ONE / 4;
        return (middle + random.nextInt(2 * steps + 1) - steps) / step * step;
    }

    private static long twiceArea(ScreenVertices v, int a) {
        long bx = v.x(a + 1) - v.x(a);
        long by = v.y(a + 1) - v.y(a);
        return bx * (v.y(a + 2) - v.y(a)) - by * (v.x(a + 2) - v.x(a));
    }

    /** No triangle is sorted into a band that its box does not touch. */
    private boolean isBeside(ScreenVertices v, int a) {
        int left = Math.min(v.x(a), Math.min(v.x(a + 1), v.x(a + 2)));
        int right = Math.max(v.x(a), Math.max(v.x(a + 1), v.x(a + 2)));
        int top = Math.min(v.y(a), Math.min(v.y(a + 1), v.y(a + 2)));
        int bottom = Math.max(v.y(a), Math.max(v.y(a + 1), v.y(a + 2)));
        return Math.min(WIDTH, Subpixels.endPixel(right)) <= Math.max(0, Subpixels.firstPixel(left))
                || Math.min(band.bottom(), Subpixels.endPixel(bottom))
                        <= Math.max(TOP, Subpixels.firstPixel(top));
    }

    @RepeatedTest(40)
    void findsWhatIsFoundOneByOne() {
        int[] seen = new int[TinyBlock.LARGE + 1];
        int next = 0;
        while (next < TRIANGLES) {
            block.take(chunk, next, TRIANGLES, mesh);
            eight.find(block, band);
            block.list();
            var listed = new ArrayList<Integer>();
            for (int place = 0; place < block.length; place++)
                listed.add(block.kind(place) * TinyBlock.SIZE + block.triangle(place));
            var wanted = new ArrayList<Integer>();
            for (int i = 0; i < block.count; i++)
                for (int kind : compare(i, seed + ", triangle " + (next + i))) {
                    wanted.add(kind * TinyBlock.SIZE + i);
                    seen[kind]++;
                }
            assertEquals(wanted, listed, seed + ", from triangle " + next);
            next += block.count;
        }
        assertEquals(TRIANGLES, next);
        for (int kind = 0; kind < seen.length; kind++)
            assertTrue(seen[kind] > 0, "%s has kinds %s".formatted(seed, Arrays.toString(seen)));
    }

    /** Returns what should be listed of the triangle. */
    private List<Integer> compare(int i, String what) {
        int a = block.corner(i, 0);
        if (!expected.load(block.vertices, a, block.corner(i, 1), block.corner(i, 2), band))
            return List.of(TinyBlock.LARGE);
        var actual = new TinyScan();
        actual.take(block, i);
        assertEquals(numbers(expected), numbers(actual), what);
        assertEquals(expected.inverseArea, actual.inverseArea, what);
        assertEquals(expected.fromBehind, actual.fromBehind, what);
        if (expected.columns * expected.rows > TinyBlock.FEW) return List.of(TinyBlock.BOX);
        return comparePixels(i, what);
    }

    private static List<Long> numbers(TinyScan t) {
        return List.of(
                (long) t.a,
                (long) t.b,
                (long) t.c,
                (long) t.left,
                (long) t.at,
                (long) t.columns,
                (long) t.rows,
                (long) t.rowA,
                (long) t.rowB,
                (long) t.rowC,
                (long) t.stepA,
                t.stepB,
                t.stepC,
                (long) t.downA,
                t.downB,
                t.downC,
                (long) t.ownB,
                (long) t.ownC);
    }

    private List<Integer> comparePixels(int i, String what) {
        expected.look(WIDTH);
        var pixels = new ArrayList<Integer>();
        for (int k = 0; k < expected.columns * expected.rows; k++) {
            int cell = expected.at + k / expected.columns * WIDTH + k % expected.columns;
            assertEquals(cell, block.cell[k * TinyBlock.SIZE + i], what);
            if (pixels.size() < expected.count && expected.cell[pixels.size()] == cell)
                pixels.add(k);
        }
        float[] weights = new float[2 * pixels.size()];
        float[] found = new float[2 * pixels.size()];
        for (int n = 0; n < pixels.size(); n++) {
            weights[2 * n] = expected.edgeB[n] * expected.inverseArea;
            weights[2 * n + 1] = expected.edgeC[n] * expected.inverseArea;
            int at = pixels.get(n) * TinyBlock.SIZE + i;
            found[2 * n] = block.weightB[at];
            found[2 * n + 1] = block.weightC[at];
        }
        assertArrayEquals(weights, found, what);
        return pixels;
    }
}
