package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.Raster;

/** Weights as floats beside the exact ones. */
class RowWeightsTest {
    private static final int SIDE = 32;
    private static final double WEIGHT = 0x1p-20;

    private final ScreenVertices v = new ScreenVertices();
    private final TriangleScan scan = new TriangleScan();
    private final RowWeights weights = new RowWeights();

    /** Slivers of every thickness, of which the picture may cut off what is far from its box. */
    @RepeatedTest(20)
    void weightsOfSliversAreAsExactAsOthers(RepetitionInfo repetition) {
        int seed = repetition.getCurrentRepetition();
        var random = new Random(seed);
        Band band = Bands.of(new DepthRaster(SIDE, SIDE), 0);
        v.begin(3, 0);
        int gentle = 0;
        int steep = 0;
        for (int round = 0; round < 2000; round++) {
            place(random);
            if (TwiceArea.of(v) == 0) continue;
            scan.load(v, 0, 1, 2, band);
            if (scan.rows <= 0 || scan.boxLeft >= scan.boxRight) continue;
            scan.scan();
            weights.load(scan, v);
            if (weights.depth.gentle) gentle++;
            else if (weights.depth.compact) steep++;
            for (int row = 0; row < scan.rows; row++)
                if (scan.count[row] > 0)
                    assertRow(row, "seed %d, triangle %d, row %d".formatted(seed, round, row));
        }
        assertTrue(
                gentle > 20 && steep > 20, gentle + " gentle, " + steep + " steep, seed " + seed);
    }

    private void place(Random random) {
        int thick = 1 << random.nextInt(12);
        int reach = SIDE << random.nextInt(3);
        for (int k = 0; k < 3; k++) {
            int along = random.nextInt(reach * Subpixels.ONE);
            int x = SIDE * Subpixels.ONE - along + random.nextInt(thick);
            v.put(k, x, along + random.nextInt(thick), 0.5f, 1);
        }
    }

    private void assertRow(int row, String place) {
        weights.at(scan, row);
        double area = Math.abs(TwiceArea.of(v));
        for (int k = 0; k < scan.count[row]; k++) {
            int column = weights.first + k;
            double b = (scan.edgeB[row] + k * scan.stepB) / area;
            double c = (scan.edgeC[row] + k * scan.stepC) / area;
            assertEquals(b, weights.rowB + column * weights.toB, WEIGHT, place);
            assertEquals(c, weights.rowC + column * weights.toC, WEIGHT, place);
        }
    }

    /** A weight below 0 would count a thousandfold and leave the range of levels. */
    @Test
    void nearCornerLeavesNothingOnTheFarEdge() {
        float[] black = {0, 0, 0};
        float[] white = {255, 255, 255};
        var out = new DepthRaster(SIDE, SIDE);
        Raster raster = out.raster();
        raster.clear(0xFF123456);
        v.begin(3, 3);
        put(0, 0, 0, 0.999f, 0.001f, black);
        put(1, 198, 0, 0.985f, 1, white);
        put(2, 20 * Subpixels.ONE, 25 * Subpixels.ONE, 0.999f, 0.001f, black);
        Band band = Bands.of(out, 0);
        band.argb = raster.argb();
        scan.load(v, 0, 1, 2, band);
        scan.scan();
        SmoothFill.perspective(band, scan, v, weights);
        assertEquals(0xFF000000, raster.argb()[20 * SIDE + 16]);
    }

    private void put(int k, int x, int y, float depth, float nearness, float[] rgb) {
        v.put(k, x, y, depth, nearness);
        for (int i = 0; i < 3; i++) v.putAttribute(i, k, rgb[i]);
    }
}
