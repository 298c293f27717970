package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Small triangles by their boxes against the same by their rows. */
class TinyScanTest {
    private static final int TRIANGLES = Boolean.getBoolean("rasterlab.full") ? 2_000_000 : 50_000;
    private static final int SIDE = 40;

    private final DepthRaster out = new DepthRaster(SIDE, SIDE);
    private final ScreenVertices v = new ScreenVertices();
    private final TinyScan tiny = new TinyScan();
    private final TriangleScan rows = new TriangleScan();

    @Test
    void ownsTheSamePixelsWithTheSameWeights() {
        v.begin(3, 0);
        var random = new Random(1988);
        int found = 0;
        for (int round = 0; round < TRIANGLES; round++) {
            place(random);
            if (TwiceArea.of(v) == 0) continue;
            for (int top : new int[] {0, TriangleScan.ROWS}) {
                Band band = Bands.of(out, top);
                if (!tiny.load(v, 0, 1, 2, band)) continue;
                tiny.look(out.raster().width());
                rows.load(v, 0, 1, 2, band);
                rows.scan();
                compare("triangle %d of seed 1988, band %d".formatted(round, top));
                found += tiny.count;
            }
        }
        assertTrue(found > TRIANGLES / 2, found + " pixels were found");
    }

    /** Puts triangles often on centres, in the picture, across its rim and across two bands. */
    private void place(Random random) {
        int x = (random.nextInt(SIDE + 8) - 4) * Subpixels.ONE;
        int y = (random.nextInt(SIDE + 8) - 4) * Subpixels.ONE;
        int reach = 1 + random.nextInt(TinyScan.SIDE + 1);
        for (int k = 0; k < 3; k++) {
            boolean whole = random.nextInt(3) == 0;
            int step = whole ? Subpixels.ONE : 1;
            v.put(
                    k,
                    x + random.nextInt(reach * Subpixels.ONE / step) * step,
                    y + random.nextInt(reach * Subpixels.ONE / step) * step,
                    0,
                    0);
        }
    }

    private void compare(String triangle) {
        var owned = new BitSet();
        int at = 0;
        for (int row = 0; row < rows.rows; row++)
            for (int k = 0; k < rows.count[row]; k++) {
                owned.set((rows.top + row) * SIDE + rows.left[row] + k);
                assertEquals(rows.edgeB[row] + k * rows.stepB, tiny.edgeB[at], triangle);
                assertEquals(rows.edgeC[row] + k * rows.stepC, tiny.edgeC[at++], triangle);
            }
        assertArrayEquals(owned.stream().toArray(), Arrays.copyOf(tiny.cell, tiny.count), triangle);
        assertEquals(rows.fromBehind, tiny.fromBehind, triangle);
        assertEquals(rows.b, tiny.b, triangle);
        assertEquals(rows.inverseArea, tiny.inverseArea, triangle);
    }
}
