package rasterlab.engine.pipeline.fast;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The box of a {@linkplain RowDepth compact} triangle, eight columns at a time from its top to its
 * bottom: to ask each pixel costs less than to find where rows begin and end. One per thread.
 *
 * <p>Depths and colours have a loop each, and rows are counted as floats, as {@link VectorLoops}
 * explains. What grows from row to row by whole numbers is added up: that costs less than to make
 * eight of each row's number, or to multiply.
 */
final class VectorCompact {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = FLOATS.length();
    private static final int SIGN = Integer.SIZE - 1;
    private static final IntVector WHOLE_NUMBERS =
            IntVector.fromArray(INTS, new int[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);

    /** The numbers of a box's columns. */
    static final float[] COLUMNS = columns();

    /** An opaque colour's highest bits, above those of its red. */
    static final int OPAQUE = 0xFF000000;

    /** −1 where a pixel is owned and nearer than what was there, else 0; row by row. */
    private final int[] drawn = new int[TriangleScan.ROWS * RowDepth.WIDEST];

    private final VectorPlaces places = new VectorPlaces();

    private static float[] columns() {
        float[] columns = new float[RowDepth.WIDEST];
        for (int k = 0; k < columns.length; k++) columns[k] = k;
        return columns;
    }

    /**
     * Finds the pixels and draws them.
     *
     * @param columns {@link RowDepth#columns}, all in the picture
     */
    void draw(Band band, TriangleScan scan, LinearColors colors, int columns) {
        int first = scan.top * band.width + scan.boxLeft;
        int firstDepth = first - band.depthStart;
        depthsInLanes(band.depth, band.width, firstDepth, scan, colors.depth, columns);
        colorsInLanes(band, first, scan.rows, colors, columns);
    }

    /**
     * Finds as {@link RowLoops#findInBox} does, where all columns that are asked are in the
     * picture.
     */
    int find(float[] depth, int depthStart, int width, TriangleScan scan, RowDepth at) {
        int columns = RowDepth.columns(scan);
        int first = scan.top * width + scan.boxLeft - depthStart;
        places.findInLanes(depth, width, first, scan, at, columns);
        return places.count;
    }

    void addFound(int width, TriangleScan scan, RowWeights weights, PixelBatch batch) {
        places.addInLanes(scan.top * width + scan.boxLeft, width, weights.box, batch);
    }

    /**
     * A compact triangle's edge functions fit an int; here they are ~e, so that a pixel is owned
     * where all are negative.
     */
    private void depthsInLanes(
            float[] depth, int width, int first, TriangleScan scan, RowDepth at, int columns) {
        float cornerZ = at.cornerZ;
        float downZ = at.downZ;
        int rows = scan.rows;
        IntVector downA = IntVector.broadcast(INTS, -(int) scan.downA);
        IntVector downB = IntVector.broadcast(INTS, -(int) scan.downB);
        IntVector downC = IntVector.broadcast(INTS, -(int) scan.downC);
        for (int column = 0; column < columns; column += LANES) {
            IntVector numbers = WHOLE_NUMBERS.add(column);
            IntVector edgesA = numbers.mul(-(int) scan.stepA).add(~(int) scan.rowA);
            IntVector edgesB = numbers.mul(-(int) scan.stepB).add(~(int) scan.rowB);
            IntVector edgesC = numbers.mul(-(int) scan.stepC).add(~(int) scan.rowC);
            FloatVector depths = FloatVector.fromArray(FLOATS, COLUMNS, column).mul(at.stepZ);
            int cell = first + column;
            int place = column;
            float down = 0;
            for (int row = 0; row < rows; row++) {
                FloatVector there = FloatVector.fromArray(FLOATS, depth, cell);
                FloatVector here = depths.add(cornerZ + down * downZ);
                down += 1;
                IntVector nearer =
                        edgesA.and(edgesB)
                                .and(edgesC)
                                .and(here.sub(there).reinterpretAsInts())
                                .lanewise(VectorOperators.ASHR, SIGN);
                edgesA = edgesA.add(downA);
                edgesB = edgesB.add(downB);
                edgesC = edgesC.add(downC);
                nearer.intoArray(drawn, place);
                IntVector before = there.reinterpretAsInts();
                before.lanewise(VectorOperators.XOR, here.reinterpretAsInts())
                        .and(nearer)
                        .lanewise(VectorOperators.XOR, before)
                        .reinterpretAsFloats()
                        .intoArray(depth, cell);
                cell += width;
                place += columns;
            }
        }
    }

    private void colorsInLanes(Band band, int first, int rows, LinearColors colors, int columns) {
        int[] argb = band.argb;
        int width = band.width;
        IntVector downRed = IntVector.broadcast(INTS, colors.downRed);
        IntVector downGreen = IntVector.broadcast(INTS, colors.downGreen);
        IntVector downBlue = IntVector.broadcast(INTS, colors.downBlue);
        for (int column = 0; column < columns; column += LANES) {
            IntVector numbers = WHOLE_NUMBERS.add(column);
            IntVector reds = numbers.mul(colors.stepRed).add(colors.cornerRed + OPAQUE);
            IntVector greens = numbers.mul(colors.stepGreen).add(colors.cornerGreen);
            IntVector blues = numbers.mul(colors.stepBlue).add(colors.cornerBlue);
            int cell = first + column;
            int place = column;
            for (int row = 0; row < rows; row++) {
                IntVector color =
                        reds.and(0xFFFF0000)
                                .or(greens.lanewise(VectorOperators.LSHR, 8).and(0xFF00))
                                .or(blues.lanewise(VectorOperators.LSHR, 16));
                reds = reds.add(downRed);
                greens = greens.add(downGreen);
                blues = blues.add(downBlue);
                IntVector before = IntVector.fromArray(INTS, argb, cell);
                before.lanewise(VectorOperators.XOR, color)
                        .and(IntVector.fromArray(INTS, drawn, place))
                        .lanewise(VectorOperators.XOR, before)
                        .intoArray(argb, cell);
                cell += width;
                place += columns;
            }
        }
    }
}
