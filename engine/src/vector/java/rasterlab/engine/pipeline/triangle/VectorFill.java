package rasterlab.engine.pipeline.triangle;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/** {@link SmoothFill}, eight pixels of a row at a time. */
final class VectorFill {
    static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    static final int LANES = FLOATS.length();
    static final FloatVector NUMBERS =
            FloatVector.fromArray(FLOATS, new float[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);
    private static final IntVector WHOLE_NUMBERS =
            IntVector.fromArray(INTS, new int[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);

    private VectorFill() {}

    /**
     * @param end the cell after the band's last
     */
    static void linear(
            DepthRaster out, TriangleScan scan, VectorRows rows, LinearColors colors, int end) {
        int width = out.width();
        IntVector reds = WHOLE_NUMBERS.mul(colors.stepRed);
        IntVector greens = WHOLE_NUMBERS.mul(colors.stepGreen);
        IntVector blues = WHOLE_NUMBERS.mul(colors.stepBlue);
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        for (int row = 0; row < scan.rows; row++) {
            int n = (int) rows.count[row];
            if (n == 0) continue;
            colors.at(
                    (float) rows.edgeB[row] * scan.inverseArea,
                    (float) rows.edgeC[row] * scan.inverseArea);
            int from = (scan.top + row) * width + scan.boxLeft + (int) rows.from[row];
            if (from + n + LANES > end) {
                SmoothFill.linear(out, from, n, colors);
                continue;
            }
            for (int done = 0; done < n; done += LANES) {
                FloatVector k = NUMBERS.add(done);
                FloatVector here = k.mul(colors.stepZ).add(colors.z);
                FloatVector there = FloatVector.fromArray(FLOATS, depth, from + done);
                VectorMask<Float> nearer =
                        here.compare(VectorOperators.LT, there)
                                .and(k.compare(VectorOperators.LT, n));
                there.blend(here, nearer).intoArray(depth, from + done);
                IntVector red = reds.add(colors.red + done * colors.stepRed);
                IntVector green = greens.add(colors.green + done * colors.stepGreen);
                IntVector blue = blues.add(colors.blue + done * colors.stepBlue);
                IntVector color =
                        red.and(0xFF0000)
                                .or(green.lanewise(VectorOperators.LSHR, 8).and(0xFF00))
                                .or(blue.lanewise(VectorOperators.LSHR, 16))
                                .or(0xFF000000);
                IntVector.fromArray(INTS, argb, from + done)
                        .blend(color, nearer.cast(INTS))
                        .intoArray(argb, from + done);
            }
        }
    }
}
