package rasterlab.engine.pipeline.fast;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * What {@link TinyScan#look} and {@link TinyFill#smooth} do, a row of the box at a time. One per
 * thread.
 *
 * <p>Depths, shares and colours have a loop each, as {@link VectorLoops} explains.
 */
final class VectorTiny {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = FLOATS.length();
    private static final FloatVector NUMBERS =
            FloatVector.fromArray(FLOATS, new float[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);

    private final VectorPlaces places = new VectorPlaces();
    private final BoxWeights weights = new BoxWeights();
    private final SmoothCorners corners = new SmoothCorners();

    /** The weights of b and c at each pixel of the box; then their shares. */
    private final float[] weightsB = new float[TinyScan.MOST];

    private final float[] weightsC = new float[TinyScan.MOST];

    /** −1 where a pixel is owned and nearer than what was there, else 0. */
    private final int[] drawn = new int[TinyScan.MOST];

    void draw(Band band, TinyScan scan, ScreenVertices v) {
        corners.load(scan, v);
        int first = scan.at - band.depthStart;
        depthsInLanes(band.depth, first, band.width, scan, corners.za, corners.zb, corners.zc);
        sharesInLanes(scan.rows, corners);
        colorsInLanes(band.argb, band.width, scan, corners);
    }

    /** Collects as {@link RowLoops#collect} does, where depths are written at once. */
    void collect(
            float[] depth,
            int depthStart,
            int width,
            TinyScan scan,
            ScreenVertices v,
            PixelBatch batch) {
        float za = v.depth(scan.a);
        float zb = v.depth(scan.b) - za;
        float zc = v.depth(scan.c) - za;
        depthsInLanes(depth, scan.at - depthStart, width, scan, za, zb, zc);
        places.listInLanes(drawn, scan.rows);
        weights.load(scan);
        places.addInLanes(scan.at, width, weights, batch);
    }

    /**
     * Edge functions are negated, so that a pixel is owned where all are negative; half a unit
     * makes a number of each that has a sign.
     */
    private void depthsInLanes(
            float[] depth, int first, int width, TinyScan scan, float za, float zb, float zc) {
        FloatVector columnsA = NUMBERS.mul(-scan.stepA);
        FloatVector columnsB = NUMBERS.mul(-scan.stepB);
        FloatVector columnsC = NUMBERS.mul(-scan.stepC);
        FloatVector scale = FloatVector.broadcast(FLOATS, -scan.inverseArea);
        float ownB = scan.ownB + 0.5f;
        float ownC = scan.ownC + 0.5f;
        float rowA = scan.rowA + 0.5f;
        float rowB = scan.rowB;
        float rowC = scan.rowC;
        float downA = scan.downA;
        float downB = scan.downB;
        float downC = scan.downC;
        int rows = scan.rows;
        float down = 0;
        for (int row = 0; row < rows; row++) {
            int cell = first + row * width;
            FloatVector eA = columnsA.sub(rowA + down * downA);
            FloatVector eB = columnsB.sub(rowB + down * downB);
            FloatVector eC = columnsC.sub(rowC + down * downC);
            down += 1;
            IntVector owned =
                    eA.reinterpretAsInts()
                            .and(eB.sub(ownB).reinterpretAsInts())
                            .and(eC.sub(ownC).reinterpretAsInts());
            FloatVector weightB = eB.mul(scale);
            FloatVector weightC = eC.mul(scale);
            weightB.intoArray(weightsB, row * LANES);
            weightC.intoArray(weightsC, row * LANES);
            FloatVector there = FloatVector.fromArray(FLOATS, depth, cell);
            FloatVector here = weightB.mul(zb).add(za).add(weightC.mul(zc));
            IntVector nearer =
                    owned.and(here.sub(there).reinterpretAsInts())
                            .lanewise(VectorOperators.ASHR, Integer.SIZE - 1);
            nearer.intoArray(drawn, row * LANES);
            IntVector before = there.reinterpretAsInts();
            before.lanewise(VectorOperators.XOR, here.reinterpretAsInts())
                    .and(nearer)
                    .lanewise(VectorOperators.XOR, before)
                    .reinterpretAsFloats()
                    .intoArray(depth, cell);
        }
    }

    /** Computes, in place of the weights, what {@link TinyFill#smooth} calls shares. */
    private void sharesInLanes(int rows, SmoothCorners at) {
        for (int from = 0; from < rows * LANES; from += LANES) {
            FloatVector weightB = FloatVector.fromArray(FLOATS, weightsB, from);
            FloatVector weightC = FloatVector.fromArray(FLOATS, weightsC, from);
            FloatVector q = weightB.mul(at.qb).add(at.qa).add(weightC.mul(at.qc));
            FloatVector w = FloatVector.broadcast(FLOATS, 1).div(q);
            weightB.mul(at.ofB).mul(w).intoArray(weightsB, from);
            weightC.mul(at.ofC).mul(w).intoArray(weightsC, from);
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
                            .or(VectorCompact.OPAQUE);
            IntVector before = IntVector.fromArray(INTS, argb, cell);
            before.lanewise(VectorOperators.XOR, color)
                    .and(IntVector.fromArray(INTS, drawn, row * LANES))
                    .lanewise(VectorOperators.XOR, before)
                    .intoArray(argb, cell);
        }
    }
}
