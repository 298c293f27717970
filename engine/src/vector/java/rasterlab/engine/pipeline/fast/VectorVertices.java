package rasterlab.engine.pipeline.fast;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Four vertices at a time where numbers are doubles, else eight, each as {@link PlainVertices} has
 * it.
 *
 * <p>Several loops, as {@link VectorLoops} explains.
 */
final class VectorVertices implements VertexLoops {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final VectorSpecies<Float> FOUR_FLOATS = FloatVector.SPECIES_128;
    private static final VectorSpecies<Double> FOUR = DoubleVector.SPECIES_256;
    private static final int Y_BITS = Integer.SIZE;

    @Override
    public boolean allSeen(int n, float[] x, float[] y, float[] z, float[] w) {
        return beyondInLanes(n, x, y, z, w) >= 0;
    }

    /** Negative where a vertex, or what a cell beyond the last one holds, is beyond a plane. */
    private static int beyondInLanes(int n, float[] x, float[] y, float[] z, float[] w) {
        IntVector beyond = IntVector.zero(INTS);
        for (int i = 0; i < n; i += FLOATS.length()) {
            FloatVector here = FloatVector.fromArray(FLOATS, w, i);
            beyond =
                    beyond.or(margin(here, x, i))
                            .or(margin(here, y, i))
                            .or(margin(here, z, i))
                            .or(here.sub(ClipCode.SMALLEST_W).reinterpretAsInts());
        }
        return beyond.reduceLanes(VectorOperators.OR);
    }

    private static IntVector margin(FloatVector w, float[] coordinate, int i) {
        return w.sub(FloatVector.fromArray(FLOATS, coordinate, i).abs()).reinterpretAsInts();
    }

    @Override
    public void place(
            int n, float[] x, float[] y, float[] w, Subpixels subpixels, long[] places, int from) {
        placeInLanes(n, x, y, w, subpixels.halfWidth, subpixels.halfHeight, places, from);
    }

    /** A rounded number is the lower half of its double's bits. */
    private static void placeInLanes(
            int n,
            float[] x,
            float[] y,
            float[] w,
            double halfWidth,
            double halfHeight,
            long[] places,
            int from) {
        for (int i = 0; i < n; i += FOUR.length()) {
            DoubleVector one = DoubleVector.broadcast(FOUR, 1);
            DoubleVector nearness = one.div(doubles(w, i));
            DoubleVector right = doubles(x, i).mul(nearness).add(1).mul(halfWidth);
            DoubleVector down = one.sub(doubles(y, i).mul(nearness)).mul(halfHeight);
            LongVector pixelX = right.add(Subpixels.ROUND).reinterpretAsLongs();
            LongVector pixelY = down.add(Subpixels.ROUND).reinterpretAsLongs();
            pixelY.lanewise(VectorOperators.LSHL, Y_BITS)
                    .or(pixelX.and(ScreenVertices.X_MASK))
                    .intoArray(places, from + i);
        }
    }

    @Override
    public void depths(int n, float[] z, float[] w) {
        depthsInLanes(n, z, w);
    }

    private static void depthsInLanes(int n, float[] z, float[] w) {
        for (int i = 0; i < n; i += FOUR.length()) {
            DoubleVector nearness = DoubleVector.broadcast(FOUR, 1).div(doubles(w, i));
            floats(doubles(z, i).mul(nearness).mul(0.5).add(0.5)).intoArray(z, i);
            floats(nearness).intoArray(w, i);
        }
    }

    private static DoubleVector doubles(float[] values, int i) {
        return (DoubleVector)
                FloatVector.fromArray(FOUR_FLOATS, values, i)
                        .convertShape(VectorOperators.F2D, FOUR, 0);
    }

    private static FloatVector floats(DoubleVector values) {
        return (FloatVector) values.convertShape(VectorOperators.D2F, FOUR_FLOATS, 0);
    }
}
