package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.function.IntToDoubleFunction;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;

/** Depths and colours of rows beside the corners' mean by exact weights. */
class LinearColorsTest {
    private static final int SIDE = 32;

    /** Depths of 24 bits, of which the last four may be lost. */
    private static final double DEPTH = 0x1p-20;

    /** The tolerance, in levels. */
    private static final double LEVEL = 0.01;

    private final ScreenVertices v = new ScreenVertices();
    private final TriangleScan scan = new TriangleScan();
    private final LinearColors colors = new LinearColors();

    /** The slivers range from 1/256 pixel to half of the box. */
    @RepeatedTest(20)
    void rowsOfSliversAreAsExactAsOthers(RepetitionInfo repetition) {
        int seed = repetition.getCurrentRepetition();
        var random = new Random(seed);
        Band band = Bands.of(new DepthRaster(SIDE, SIDE), 0);
        v.begin(3, 3);
        int compact = 0;
        int others = 0;
        for (int round = 0; round < 500; round++) {
            place(random);
            if (TwiceArea.of(v) == 0) continue;
            scan.load(v, 0, 1, 2, band);
            scan.scan();
            colors.load(scan, v);
            for (int row = 0; row < scan.rows; row++) {
                if (scan.count[row] == 0) continue;
                if (colors.depth.compact) compact++;
                else others++;
                assertRow(row, "seed %d, triangle %d, row %d".formatted(seed, round, row));
            }
        }
        assertTrue(compact > 100 && others > 100, compact + " compact rows, " + others + " others");
    }

    private void place(Random random) {
        int thick = 1 << random.nextInt(12);
        for (int k = 0; k < 3; k++) {
            int along = random.nextInt(20 * Subpixels.ONE);
            int x = along + random.nextInt(thick);
            int y = 20 * Subpixels.ONE - along + random.nextInt(thick);
            v.put(k, x, y, random.nextFloat(), 1);
            for (int i = 0; i < 3; i++) v.putAttribute(i, k, random.nextInt(256));
        }
    }

    private void assertRow(int row, String place) {
        colors.at(scan, row);
        RowDepth at = colors.depth;
        double area = Math.abs(TwiceArea.of(v));
        for (int k = 0; k < scan.count[row]; k++) {
            double b = (scan.edgeB[row] + k * scan.stepB) / area;
            double c = (scan.edgeC[row] + k * scan.stepC) / area;
            float z = at.z + (at.first + k) * at.stepZ;
            assertEquals(between(v::depth, b, c), z, DEPTH, place);
            double red = (colors.red + k * colors.stepRed) / 65536.0 - 0.5;
            assertEquals(between(vertex -> v.attribute(0, vertex), b, c), red, LEVEL, place);
        }
    }

    private double between(IntToDoubleFunction of, double b, double c) {
        return of.applyAsDouble(scan.a) * (1 - b - c)
                + of.applyAsDouble(scan.b) * b
                + of.applyAsDouble(scan.c) * c;
    }
}
