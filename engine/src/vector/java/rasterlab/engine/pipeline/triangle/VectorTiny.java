package rasterlab.engine.pipeline.triangle;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * What {@link TinyScan#look} and {@link TinyFill#smooth} do, a row of the box at a time. One per
 * thread.
 *
 * <p>Depths, divisions and colours have a loop each, as {@link VectorLoops} explains.
 */
final class VectorTiny {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = FLOATS.length();
    private static final FloatVector NUMBERS =
            FloatVector.fromArray(FLOATS, new float[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);

    private final SmoothCorners corners = new SmoothCorners();

    /** Of each pixel of the box. */
    private final float[] weightsB = new float[TinyScan.MOST];

    private final float[] weightsC = new float[TinyScan.MOST];

    /** Negative where a pixel is owned and nearer than what was there. */
    private final int[] drawn = new int[TinyScan.MOST];

    void draw(Band band, TinyScan scan, ScreenVertices v) {
        corners.load(scan, v);
        depthsInLanes(band.depth, scan.at - band.depthStart, band.width, scan, corners);
        sharesInLanes(scan.rows, corners);
        colorsInLanes(band.argb, band.width, scan, corners);
    }

    /** Half a unit more makes a number of every edge function that has a sign. */
    private void depthsInLanes(
            float[] depth, int first, int width, TinyScan scan, SmoothCorners at) {
        FloatVector columnsA = NUMBERS.mul(scan.stepA).add(0.5f);
        FloatVector columnsB = NUMBERS.mul(scan.stepB);
        FloatVector columnsC = NUMBERS.mul(scan.stepC);
        int downB = (int) scan.downB;
        int downC = (int) scan.downC;
        for (int row = 0; row < scan.rows; row++) {
            int cell = first + row * width;
            FloatVector eA = columnsA.add(scan.rowA + row * scan.downA);
            FloatVector eB = columnsB.add(scan.rowB + row * downB);
            FloatVector eC = columnsC.add(scan.rowC + row * downC);
            IntVector beyond =
                    eA.reinterpretAsInts()
                            .or(eB.add(scan.ownB + 0.5f).reinterpretAsInts())
                            .or(eC.add(scan.ownC + 0.5f).reinterpretAsInts());
            FloatVector weightB = eB.mul(at.inverseArea);
            FloatVector weightC = eC.mul(at.inverseArea);
            weightB.intoArray(weightsB, row * LANES);
            weightC.intoArray(weightsC, row * LANES);
            FloatVector there = FloatVector.fromArray(FLOATS, depth, cell);
            FloatVector here = weightB.mul(at.zb).add(at.za).add(weightC.mul(at.zc));
            IntVector nearer = beyond.not().and(here.sub(there).reinterpretAsInts());
            nearer.intoArray(drawn, row * LANES);
            there.reinterpretAsInts()
                    .blend(here.reinterpretAsInts(), nearer.compare(VectorOperators.LT, 0))
                    .reinterpretAsFloats()
                    .intoArray(depth, cell);
        }
    }

    /** Makes weights those in space, each pixel's by a division. */
    private void sharesInLanes(int rows, SmoothCorners at) {
        for (int i = 0; i < rows * LANES; i += LANES) {
            FloatVector weightB = FloatVector.fromArray(FLOATS, weightsB, i);
            FloatVector weightC = FloatVector.fromArray(FLOATS, weightsC, i);
            FloatVector q = weightB.mul(at.qb).add(at.qa).add(weightC.mul(at.qc));
            FloatVector w = FloatVector.broadcast(FLOATS, 1).div(q);
            weightB.mul(at.ofB).mul(w).intoArray(weightsB, i);
            weightC.mul(at.ofC).mul(w).intoArray(weightsC, i);
        }
    }

    private void colorsInLanes(int[] argb, int width, TinyScan scan, SmoothCorners at) {
        for (int row = 0; row < scan.rows; row++) {
            int cell = scan.at + row * width;
            FloatVector shareB = FloatVector.fromArray(FLOATS, weightsB, row * LANES);
            FloatVector shareC = FloatVector.fromArray(FLOATS, weightsC, row * LANES);
            FloatVector red = shareB.mul(at.rb).add(at.ra).add(shareC.mul(at.rc));
            FloatVector green = shareB.mul(at.gb).add(at.ga).add(shareC.mul(at.gc));
            FloatVector blue = shareB.mul(at.bb).add(at.ba).add(shareC.mul(at.bc));
            IntVector reds = red.add(SmoothFill.ROUND).reinterpretAsInts();
            IntVector greens = green.add(SmoothFill.ROUND).reinterpretAsInts();
            IntVector color =
                    reds.lanewise(VectorOperators.LSHL, 16)
                            .or(greens.lanewise(VectorOperators.LSHL, 8))
                            .or(blue.add(SmoothFill.ROUND).reinterpretAsInts())
                            .or(0xFF000000);
            VectorMask<Integer> nearer =
                    IntVector.fromArray(INTS, drawn, row * LANES).compare(VectorOperators.LT, 0);
            IntVector.fromArray(INTS, argb, cell).blend(color, nearer).intoArray(argb, cell);
        }
    }
}
