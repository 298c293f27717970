package rasterlab.engine.pipeline.triangle;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Eight or sixteen columns of the box of a {@linkplain RowDepth compact} triangle, row by row: to
 * ask each pixel costs less than to find where rows begin and end. One per thread.
 *
 * <p>Depths and colours have a loop each, as {@link VectorLoops} explains. Sixteen columns share
 * what a row begins with; their loop for depths holds as many operations as a loop may.
 */
final class VectorCompact {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = FLOATS.length();
    private static final int PAIR = 2 * LANES;
    private static final int SIGN = Integer.SIZE - 1;
    private static final IntVector WHOLE_NUMBERS =
            IntVector.fromArray(INTS, new int[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);

    /** The numbers of a box's columns. */
    private static final float[] COLUMNS = columns();

    /** An opaque colour's highest bits, above those of its red. */
    static final int OPAQUE = 0xFF000000;

    /** −1 where a pixel is owned and nearer than what was there, else 0. */
    private final int[] drawn = new int[TriangleScan.ROWS * PAIR];

    private final VectorPlaces places = new VectorPlaces();

    private static float[] columns() {
        float[] columns = new float[RowDepth.WIDEST];
        for (int k = 0; k < columns.length; k++) columns[k] = k;
        return columns;
    }

    /**
     * @param column of the box, the first of eight that are in the picture
     */
    void draw(Band band, TriangleScan scan, LinearColors colors, int column) {
        int cell = scan.top * band.width + scan.boxLeft + column;
        depthsInLanes(band.depth, band.width, cell - band.depthStart, scan, colors.depth, column);
        colorsInLanes(band, cell, scan.rows, colors, column);
    }

    /**
     * The same with sixteen columns.
     *
     * @param column of the box, the first of sixteen that are in the picture
     */
    void drawPair(Band band, TriangleScan scan, LinearColors colors, int column) {
        int cell = scan.top * band.width + scan.boxLeft + column;
        depthsOfPairInLanes(
                band.depth, band.width, cell - band.depthStart, scan, colors.depth, column);
        colorsOfPairInLanes(band, cell, scan.rows, colors, column);
    }

    /** As {@link RowLoops#findInBox} does, where all columns that are asked are in the picture. */
    int find(float[] depth, int depthStart, int width, TriangleScan scan, RowDepth at) {
        int first = scan.top * width + scan.boxLeft - depthStart;
        int columns = RowDepth.columns(scan);
        places.count = 0;
        int column = 0;
        for (; column + PAIR <= columns; column += PAIR) {
            depthsOfPairInLanes(depth, width, first + column, scan, at, column);
            places.listInLanes(drawn, 0, PAIR, scan.rows, column);
            places.listInLanes(drawn, LANES, PAIR, scan.rows, column + LANES);
        }
        if (column < columns) {
            depthsInLanes(depth, width, first + column, scan, at, column);
            places.listInLanes(drawn, 0, LANES, scan.rows, column);
        }
        return places.count;
    }

    void addFound(int width, TriangleScan scan, RowWeights weights, PixelBatch batch) {
        places.addInLanes(scan.top * width + scan.boxLeft, width, weights.box, batch);
    }

    /** In a box of {@value RowDepth#WIDEST} columns edge functions fit an int. */
    private void depthsInLanes(
            float[] depth, int width, int first, TriangleScan scan, RowDepth at, int column) {
        IntVector columns = WHOLE_NUMBERS.add(column);
        IntVector edgesA = columns.mul((int) scan.stepA).add((int) scan.rowA);
        IntVector edgesB = columns.mul((int) scan.stepB).add((int) scan.rowB);
        IntVector edgesC = columns.mul((int) scan.stepC).add((int) scan.rowC);
        FloatVector depths = FloatVector.fromArray(FLOATS, COLUMNS, column).mul(at.stepZ);
        int downA = (int) scan.downA;
        int downB = (int) scan.downB;
        int downC = (int) scan.downC;
        double cornerZ = at.cornerZ;
        double downZ = at.downZ;
        for (int row = 0; row < scan.rows; row++) {
            int cell = first + row * width;
            FloatVector there = FloatVector.fromArray(FLOATS, depth, cell);
            FloatVector here = depths.add((float) (cornerZ + row * downZ));
            IntVector nearer =
                    edgesA.add(row * downA)
                            .or(edgesB.add(row * downB))
                            .or(edgesC.add(row * downC))
                            .not()
                            .and(here.sub(there).reinterpretAsInts())
                            .lanewise(VectorOperators.ASHR, SIGN);
            nearer.intoArray(drawn, row * LANES);
            IntVector before = there.reinterpretAsInts();
            before.lanewise(VectorOperators.XOR, here.reinterpretAsInts())
                    .and(nearer)
                    .lanewise(VectorOperators.XOR, before)
                    .reinterpretAsFloats()
                    .intoArray(depth, cell);
        }
    }

    private void colorsInLanes(Band band, int first, int rows, LinearColors colors, int column) {
        int[] argb = band.argb;
        int width = band.width;
        IntVector columns = WHOLE_NUMBERS.add(column);
        IntVector reds = columns.mul(colors.stepRed).add(colors.cornerRed + OPAQUE);
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
                    reds.add(row * downRed).and(0xFFFF0000).or(green.and(0xFF00)).or(blue);
            IntVector before = IntVector.fromArray(INTS, argb, cell);
            before.lanewise(VectorOperators.XOR, color)
                    .and(IntVector.fromArray(INTS, drawn, row * LANES))
                    .lanewise(VectorOperators.XOR, before)
                    .intoArray(argb, cell);
        }
    }

    private void depthsOfPairInLanes(
            float[] depth, int width, int first, TriangleScan scan, RowDepth at, int column) {
        int stepA = (int) scan.stepA;
        int stepB = (int) scan.stepB;
        int stepC = (int) scan.stepC;
        IntVector edgesA = WHOLE_NUMBERS.mul(stepA).add((int) scan.rowA + column * stepA);
        IntVector edgesB = WHOLE_NUMBERS.mul(stepB).add((int) scan.rowB + column * stepB);
        IntVector edgesC = WHOLE_NUMBERS.mul(stepC).add((int) scan.rowC + column * stepC);
        IntVector nextA = edgesA.add(LANES * stepA);
        IntVector nextB = edgesB.add(LANES * stepB);
        IntVector nextC = edgesC.add(LANES * stepC);
        FloatVector depths = FloatVector.fromArray(FLOATS, COLUMNS, column).mul(at.stepZ);
        FloatVector nextDepths =
                FloatVector.fromArray(FLOATS, COLUMNS, column + LANES).mul(at.stepZ);
        int downA = (int) scan.downA;
        int downB = (int) scan.downB;
        int downC = (int) scan.downC;
        double cornerZ = at.cornerZ;
        double downZ = at.downZ;
        for (int row = 0; row < scan.rows; row++) {
            int cell = first + row * width;
            float z = (float) (cornerZ + row * downZ);
            FloatVector there = FloatVector.fromArray(FLOATS, depth, cell);
            FloatVector here = depths.add(z);
            IntVector nearer =
                    edgesA.add(row * downA)
                            .or(edgesB.add(row * downB))
                            .or(edgesC.add(row * downC))
                            .not()
                            .and(here.sub(there).reinterpretAsInts())
                            .lanewise(VectorOperators.ASHR, SIGN);
            nearer.intoArray(drawn, row * PAIR);
            IntVector before = there.reinterpretAsInts();
            before.lanewise(VectorOperators.XOR, here.reinterpretAsInts())
                    .and(nearer)
                    .lanewise(VectorOperators.XOR, before)
                    .reinterpretAsFloats()
                    .intoArray(depth, cell);
            there = FloatVector.fromArray(FLOATS, depth, cell + LANES);
            here = nextDepths.add(z);
            nearer =
                    nextA.add(row * downA)
                            .or(nextB.add(row * downB))
                            .or(nextC.add(row * downC))
                            .not()
                            .and(here.sub(there).reinterpretAsInts())
                            .lanewise(VectorOperators.ASHR, SIGN);
            nearer.intoArray(drawn, row * PAIR + LANES);
            before = there.reinterpretAsInts();
            before.lanewise(VectorOperators.XOR, here.reinterpretAsInts())
                    .and(nearer)
                    .lanewise(VectorOperators.XOR, before)
                    .reinterpretAsFloats()
                    .intoArray(depth, cell + LANES);
        }
    }

    private void colorsOfPairInLanes(
            Band band, int first, int rows, LinearColors colors, int column) {
        int[] argb = band.argb;
        int width = band.width;
        IntVector columns = WHOLE_NUMBERS.add(column);
        IntVector reds = columns.mul(colors.stepRed).add(colors.cornerRed + OPAQUE);
        IntVector greens = columns.mul(colors.stepGreen).add(colors.cornerGreen);
        IntVector blues = columns.mul(colors.stepBlue).add(colors.cornerBlue);
        IntVector nextReds = reds.add(LANES * colors.stepRed);
        IntVector nextGreens = greens.add(LANES * colors.stepGreen);
        IntVector nextBlues = blues.add(LANES * colors.stepBlue);
        int downRed = colors.downRed;
        int downGreen = colors.downGreen;
        int downBlue = colors.downBlue;
        for (int row = 0; row < rows; row++) {
            int cell = first + row * width;
            IntVector green = greens.add(row * downGreen).lanewise(VectorOperators.LSHR, 8);
            IntVector blue = blues.add(row * downBlue).lanewise(VectorOperators.LSHR, 16);
            IntVector color =
                    reds.add(row * downRed).and(0xFFFF0000).or(green.and(0xFF00)).or(blue);
            IntVector before = IntVector.fromArray(INTS, argb, cell);
            before.lanewise(VectorOperators.XOR, color)
                    .and(IntVector.fromArray(INTS, drawn, row * PAIR))
                    .lanewise(VectorOperators.XOR, before)
                    .intoArray(argb, cell);
            green = nextGreens.add(row * downGreen).lanewise(VectorOperators.LSHR, 8);
            blue = nextBlues.add(row * downBlue).lanewise(VectorOperators.LSHR, 16);
            color = nextReds.add(row * downRed).and(0xFFFF0000).or(green.and(0xFF00)).or(blue);
            before = IntVector.fromArray(INTS, argb, cell + LANES);
            before.lanewise(VectorOperators.XOR, color)
                    .and(IntVector.fromArray(INTS, drawn, row * PAIR + LANES))
                    .lanewise(VectorOperators.XOR, before)
                    .intoArray(argb, cell + LANES);
        }
    }
}
