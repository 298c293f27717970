package rasterlab.engine.pipeline.triangle;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Eight columns of the box of a {@linkplain RowDepth compact} triangle, row by row: to ask each
 * pixel costs less than to find where rows begin and end. One per thread.
 *
 * <p>Depths and colours have a loop each, as {@link VectorLoops} explains.
 */
final class VectorCompact {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = FLOATS.length();
    private static final FloatVector NUMBERS =
            FloatVector.fromArray(FLOATS, new float[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);
    private static final IntVector WHOLE_NUMBERS =
            IntVector.fromArray(INTS, new int[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);

    /** Negative where a pixel is owned and nearer than what was there. */
    private final int[] drawn = new int[TriangleScan.ROWS * LANES];

    /**
     * @param column of the box, the first of eight that are in the picture
     */
    void draw(Band band, TriangleScan scan, LinearColors colors, int column) {
        int cell = scan.top * band.width + scan.boxLeft + column;
        depthsInLanes(band, cell - band.depthStart, scan, colors, column);
        colorsInLanes(band, cell, scan.rows, colors, column);
    }

    /** In a box of {@value RowDepth#WIDEST} columns edge functions fit an int. */
    private void depthsInLanes(
            Band band, int first, TriangleScan scan, LinearColors colors, int column) {
        float[] depth = band.depth;
        int width = band.width;
        IntVector columns = WHOLE_NUMBERS.add(column);
        IntVector edgesA = columns.mul((int) scan.stepA).add((int) scan.rowA);
        IntVector edgesB = columns.mul((int) scan.stepB).add((int) scan.rowB);
        IntVector edgesC = columns.mul((int) scan.stepC).add((int) scan.rowC);
        FloatVector depths = NUMBERS.add(column).mul(colors.depth.stepZ);
        int downA = (int) scan.downA;
        int downB = (int) scan.downB;
        int downC = (int) scan.downC;
        double cornerZ = colors.depth.cornerZ;
        double downZ = colors.depth.downZ;
        for (int row = 0; row < scan.rows; row++) {
            int cell = first + row * width;
            FloatVector there = FloatVector.fromArray(FLOATS, depth, cell);
            FloatVector here = depths.add((float) (cornerZ + row * downZ));
            IntVector nearer =
                    edgesA.add(row * downA)
                            .or(edgesB.add(row * downB))
                            .or(edgesC.add(row * downC))
                            .not()
                            .and(here.sub(there).reinterpretAsInts());
            nearer.intoArray(drawn, row * LANES);
            there.reinterpretAsInts()
                    .blend(here.reinterpretAsInts(), nearer.compare(VectorOperators.LT, 0))
                    .reinterpretAsFloats()
                    .intoArray(depth, cell);
        }
    }

    private void colorsInLanes(Band band, int first, int rows, LinearColors colors, int column) {
        int[] argb = band.argb;
        int width = band.width;
        IntVector columns = WHOLE_NUMBERS.add(column);
        IntVector reds = columns.mul(colors.stepRed).add(colors.cornerRed);
        IntVector greens = columns.mul(colors.stepGreen).add(colors.cornerGreen);
        IntVector blues = columns.mul(colors.stepBlue).add(colors.cornerBlue);
        int downRed = colors.downRed;
        int downGreen = colors.downGreen;
        int downBlue = colors.downBlue;
        for (int row = 0; row < rows; row++) {
            int cell = first + row * width;
            IntVector green = greens.add(row * downGreen).lanewise(VectorOperators.LSHR, 8);
            IntVector blue = blues.add(row * downBlue).lanewise(VectorOperators.LSHR, 16);
            IntVector color =
                    reds.add(row * downRed)
                            .and(0xFF0000)
                            .or(green.and(0xFF00))
                            .or(blue)
                            .or(0xFF000000);
            VectorMask<Integer> nearer =
                    IntVector.fromArray(INTS, drawn, row * LANES).compare(VectorOperators.LT, 0);
            IntVector.fromArray(INTS, argb, cell).blend(color, nearer).intoArray(argb, cell);
        }
    }
}
