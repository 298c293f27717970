package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.EightLanes;

/** The triangles of a block beside the same ones found one by one, bit for bit. */
@Tag("slow")
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
    void needEight() {
        EightLanes.assumeThere();
        eight = RowLoops.of(Lanes.EIGHT);
    }

    private void placeTriangles(RepetitionInfo repetition) {
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

    /**
     * Puts triangles in the band and the picture or across their ends, some large, some on whole
     * pixels.
     */
    private void place(ScreenVertices v, int first) {
        int reach = 1 << random.nextInt(random.nextInt(10) == 0 ? 18 : 4);
        int step = random.nextInt(3) == 0 ? Subpixels.ONE : 1;
        boolean longest = random.nextInt(20) == 0;
        do {
            int x = random.nextInt(WIDTH * Subpixels.ONE);
            int y = (TOP + random.nextInt(TriangleScan.ROWS)) * Subpixels.ONE;
            for (int k = first; k < first + 3; k++)
                v.put(k, near(x, reach, step), near(y, reach, step), 0, 0);
            if (longest) stretch(v, first);
        } while (TwiceArea.of(v, first) == 0 || isBeside(v, first));
    }

    /** Stretches a triangle to a box of the longest side that is small, or a step more. */
    private void stretch(ScreenVertices v, int first) {
        int side = TinyScan.WIDEST + random.nextInt(2);
        int across = random.nextBoolean() ? side : 0;
        int x = v.x(first);
        int y = v.y(first);
        v.put(first + 1, x + across, y + side - across, 0, 0);
        v.put(first + 2, x + random.nextInt(side), y + random.nextInt(side), 0, 0);
    }

    private int near(int middle, int reach, int step) {
        int steps = reach * Subpixels.ONE / 4;
        return (middle + random.nextInt(2 * steps + 1) - steps) / step * step;
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

    @Test
    void isDoneWhereMoreThanEveryFifthPixelHasATriangle() {
        assertTrue(RowLoops.of(Lanes.EIGHT).findsInBlocks(), "with eight lanes");
        assertFalse(RowLoops.of(Lanes.ONE).findsInBlocks(), "with one lane");
        assertFalse(BandStage.isDense(100, 500), "100 in 500");
        assertTrue(BandStage.isDense(101, 500), "101 in 500");
    }

    @RepeatedTest(40)
    void findsWhatIsFoundOneByOne(RepetitionInfo repetition) {
        placeTriangles(repetition);
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
                for (int kind : compare(i, next + i)) {
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
    private List<Integer> compare(int i, int triangle) {
        String what = seed + ", triangle " + triangle;
        int[] corner = Arrays.copyOfRange(chunk.corners, 3 * triangle, 3 * triangle + 3);
        boolean made = corner[0] < 0;
        for (int k = 0; k < 3; k++) {
            if (made) corner[k] = ~corner[k];
            assertEquals(corner[k], block.corner(i, k), what);
        }
        ScreenVertices vertices = made ? chunk.clipped : mesh;
        assertSame(vertices, block.vertices, what);
        if (!expected.load(vertices, corner[0], corner[1], corner[2], band))
            return List.of(TinyBlock.LARGE);
        var actual = new TinyScan();
        actual.take(block, i);
        assertEquals(numbers(expected), numbers(actual), what);
        assertEquals(expected.inverseArea, actual.inverseArea, what);
        assertEquals(expected.fromBehind, actual.fromBehind, what);
        if (expected.columns * expected.rows > TinyScan.FEW) return List.of(TinyBlock.BOX);
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
