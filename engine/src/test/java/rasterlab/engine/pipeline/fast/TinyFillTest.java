package rasterlab.engine.pipeline.fast;

import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;

/** A box of a few pixels beside the same box drawn as a larger one is, bit for bit. */
class TinyFillTest {
    private static final int WIDTH = 40;

    private final ScreenVertices v = new ScreenVertices();
    private final TinyScan scan = new TinyScan();
    private final SmoothCorners corners = new SmoothCorners();

    /** Where depths are equal nothing is drawn twice. */
    @RepeatedTest(40)
    void drawsAFewPixelsAsTheOthers(RepetitionInfo repetition) {
        int seed = repetition.getCurrentRepetition();
        var random = new Random(seed);
        var expected = new DepthRaster(WIDTH, TriangleScan.ROWS);
        var actual = new DepthRaster(WIDTH, TriangleScan.ROWS);
        expected.raster().clear(0xFF000000);
        actual.raster().clear(0xFF000000);
        Band band = Bands.of(expected, 0);
        for (int round = 0; round < 2000; round++) {
            place(random);
            if (!scan.load(v, 0, 1, 2, band) || scan.rows <= 0 || scan.columns <= 0) continue;
            scan.look(WIDTH);
            corners.load(scan, v);
            TinyFill.smooth(band, scan, corners);
            TinyFill.few(Bands.of(actual, 0), scan, v);
        }
        SamePicture.assertSame(expected, actual, "seed " + seed);
    }

    /** Corners within four pixels, in the picture or across its sides, each of a colour. */
    private void place(Random random) {
        v.begin(3, 3);
        int left = random.nextInt(WIDTH + 4) - 4;
        int top = random.nextInt(TriangleScan.ROWS + 4) - 4;
        for (int k = 0; k < 3; k++) {
            int x = left * Subpixels.ONE + random.nextInt(4 * Subpixels.ONE);
            int y = top * Subpixels.ONE + random.nextInt(4 * Subpixels.ONE);
            v.put(k, x, y, random.nextFloat(), 0.5f + random.nextFloat());
            for (int i = 0; i < 3; i++) v.putAttribute(i, k, random.nextInt(256));
        }
    }
}
