package rasterlab.engine.pipeline.fast;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The places in a triangle's box whose pixels are drawn, found or taken as found, listed without a
 * branch, which nobody could foresee, and added to a batch. One per thread.
 */
final class VectorPlaces {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = INTS.length();
    private static final int COLUMN_BITS = Integer.numberOfTrailingZeros(RowDepth.WIDEST);

    private static final IntVector WHOLE_NUMBERS =
            IntVector.fromArray(INTS, new int[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);

    /** A bit for each lane. */
    private static final IntVector BITS =
            IntVector.fromArray(INTS, new int[] {1, 2, 4, 8, 16, 32, 64, 128}, 0);

    /** The numbers of the lanes in each set of lanes, which is given as such bits, then zeros. */
    private static final int[] LANES_OF = lanesOf();

    /** Whole numbers below 2²³ are the lowest bits of a float that this is added to. */
    private static final float ROUND = SmoothFill.ROUND;

    static final int ROUND_BITS = Float.floatToRawIntBits(ROUND);

    /** Row and column of each place, {@code row · WIDEST + column}. */
    private final int[] places = new int[PixelBatch.ROOM];

    /** How many are listed. */
    int count;

    private static int[] lanesOf() {
        int[] lanes = new int[LANES << LANES];
        for (int set = 0; set < 1 << LANES; set++) {
            int at = set * LANES;
            for (int lane = 0; lane < LANES; lane++) if ((set >> lane & 1) != 0) lanes[at++] = lane;
        }
        return lanes;
    }

    /**
     * Lists the places of a box of eight columns.
     *
     * @param drawn row by row eight numbers, −1 or 0
     */
    void listInLanes(int[] drawn, int rows) {
        int listed = 0;
        for (int row = 0; row < rows; row++) {
            int set =
                    IntVector.fromArray(INTS, drawn, row * LANES)
                            .and(BITS)
                            .reduceLanes(VectorOperators.OR);
            IntVector.fromArray(INTS, LANES_OF, set * LANES)
                    .add(row * RowDepth.WIDEST)
                    .intoArray(places, listed);
            listed += Integer.bitCount(set);
        }
        count = listed;
    }

    /**
     * Lists the places that are owned and nearer than what was there, and writes their depths:
     * {@code depthsInLanes} of {@link VectorCompact}, but with the list in the same loop, since
     * where a second one ends would be foreseen as badly. Edge functions are ~e here, too.
     *
     * @param first the place in {@code depth} of the box's first pixel
     * @param columns {@link RowDepth#columns}, all in the picture
     */
    void findInLanes(
            float[] depth, int width, int first, TriangleScan scan, RowDepth at, int columns) {
        float cornerZ = at.cornerZ;
        float downZ = at.downZ;
        int rows = scan.rows;
        int[] list = places;
        int listed = 0;
        IntVector downA = IntVector.broadcast(INTS, -(int) scan.downA);
        IntVector downB = IntVector.broadcast(INTS, -(int) scan.downB);
        IntVector downC = IntVector.broadcast(INTS, -(int) scan.downC);
        for (int column = 0; column < columns; column += LANES) {
            IntVector numbers = WHOLE_NUMBERS.add(column);
            IntVector edgesA = numbers.mul(-(int) scan.stepA).add(~(int) scan.rowA);
            IntVector edgesB = numbers.mul(-(int) scan.stepB).add(~(int) scan.rowB);
            IntVector edgesC = numbers.mul(-(int) scan.stepC).add(~(int) scan.rowC);
            FloatVector depths =
                    FloatVector.fromArray(FLOATS, VectorCompact.COLUMNS, column).mul(at.stepZ);
            IntVector place = IntVector.broadcast(INTS, column);
            int cell = first + column;
            float down = 0;
            for (int row = 0; row < rows; row++) {
                FloatVector there = FloatVector.fromArray(FLOATS, depth, cell);
                FloatVector here = depths.add(cornerZ + down * downZ);
                down += 1;
                IntVector nearer =
                        edgesA.and(edgesB)
                                .and(edgesC)
                                .and(here.sub(there).reinterpretAsInts())
                                .lanewise(VectorOperators.ASHR, Integer.SIZE - 1);
                edgesA = edgesA.add(downA);
                edgesB = edgesB.add(downB);
                edgesC = edgesC.add(downC);
                int set = nearer.and(BITS).reduceLanes(VectorOperators.OR);
                IntVector.fromArray(INTS, LANES_OF, set * LANES).add(place).intoArray(list, listed);
                listed += Integer.bitCount(set);
                place = place.add(RowDepth.WIDEST);
                IntVector before = there.reinterpretAsInts();
                before.lanewise(VectorOperators.XOR, here.reinterpretAsInts())
                        .and(nearer)
                        .lanewise(VectorOperators.XOR, before)
                        .reinterpretAsFloats()
                        .intoArray(depth, cell);
                cell += width;
            }
        }
        count = listed;
    }

    /**
     * Adds the cells and weights of all places to a batch that has room for them.
     *
     * @param first the cell of the box's first pixel
     * @param width of the picture
     */
    void addInLanes(int first, int width, BoxWeights at, PixelBatch batch) {
        int before = batch.count;
        int[] cells = batch.cell;
        float[] weightsB = batch.weightB;
        float[] weightsC = batch.weightC;
        for (int i = 0; i < count; i += LANES) {
            IntVector place = IntVector.fromArray(INTS, places, i);
            IntVector column = place.and(RowDepth.WIDEST - 1);
            IntVector row = place.lanewise(VectorOperators.LSHR, COLUMN_BITS);
            row.mul(width).add(column).add(first).intoArray(cells, before + i);
            FloatVector right = floats(column);
            FloatVector down = floats(row);
            down.mul(at.downB)
                    .add(at.cornerB)
                    .add(right.mul(at.rightB))
                    .mul(at.scale)
                    .intoArray(weightsB, before + i);
            down.mul(at.downC)
                    .add(at.cornerC)
                    .add(right.mul(at.rightC))
                    .mul(at.scale)
                    .intoArray(weightsC, before + i);
        }
        batch.count = before + count;
    }

    /** Numbers from 0 to 2²³ − 1. */
    private static FloatVector floats(IntVector numbers) {
        return numbers.or(ROUND_BITS).reinterpretAsFloats().sub(ROUND);
    }
}
