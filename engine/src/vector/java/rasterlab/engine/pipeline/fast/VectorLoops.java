package rasterlab.engine.pipeline.fast;

import static rasterlab.engine.scene.VertexQuantity.TEXTURE_S;
import static rasterlab.engine.scene.VertexQuantity.TEXTURE_T;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import rasterlab.engine.lanes.Lanes;

/**
 * Eight pixels at a time, each computed as {@link PlainLoops} computes it.
 *
 * <p>All eight pixels are read and written back, those that the triangle does not own as they were:
 * a band belongs to one thread. Where the eight would leave the band they are drawn one by one.
 *
 * <p>Vectors stay in registers only while the compiler sees through all that is done with them;
 * Java 17 gives up after about 18 000 nodes of its graph, some fifty-five operations, and may make
 * objects of what comes then, not each time that it compiles a loop. So each loop has at most
 * fifty, a number that becomes a vector counted as one, in a method whose name ends in {@code
 * InLanes} and which is compiled on its own (see {@code vector-options}), and numbers go from one
 * to the next in arrays. A constant, {@link #NUMBERS} say, does not go from one turn of a loop to
 * the next, it would be made an object; what is computed from it may.
 *
 * <p>Loops that draw count columns and rows by adding to vectors, or to floats and doubles, and
 * turn no int into one: Java 17's conversion waits for what its register has held, which may be the
 * last that the turn before computes.
 *
 * <p>What is drawn and what stays is chosen by bits, {@code before ^ (before ^ now) & drawn}: of a
 * mask Java 17 makes three slow instructions where that is one.
 */
final class VectorLoops implements RowLoops {
    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;
    private static final int LANES = FLOATS.length();
    private static final float[] FIRST_NUMBERS = {0, 1, 2, 3, 4, 5, 6, 7};
    private static final FloatVector NUMBERS = FloatVector.fromArray(FLOATS, FIRST_NUMBERS, 0);
    private static final FloatVector NEXT = FloatVector.broadcast(FLOATS, LANES);
    private static final IntVector WHOLE_NUMBERS =
            IntVector.fromArray(INTS, new int[] {0, 1, 2, 3, 4, 5, 6, 7}, 0);

    private final VectorRows rows = new VectorRows();
    private final VectorTiny tiny = new VectorTiny();
    private final VectorTinies tinies = new VectorTinies();
    private final VectorCompact compact = new VectorCompact();
    private final PlainLoops plain = new PlainLoops();

    @Override
    public Lanes lanes() {
        return Lanes.EIGHT;
    }

    @Override
    public void scan(TriangleScan scan) {
        rows.scan(scan);
    }

    @Override
    public boolean findsInBlocks() {
        return true;
    }

    @Override
    public void find(TinyBlock block, Band band) {
        tinies.find(block, band);
    }

    @Override
    public void smooth(Band band, TinyScan scan, ScreenVertices v) {
        if (scan.left + LANES > band.width) plain.smooth(band, scan, v);
        else tiny.draw(band, scan, v);
    }

    @Override
    public void linear(Band band, TriangleScan scan, LinearColors colors) {
        int columns = RowDepth.columns(scan);
        if (colors.depth.compact && scan.boxLeft + columns <= band.width) {
            compact.draw(band, scan, colors, columns);
            return;
        }
        rows.scan(scan);
        if (columns > RowDepth.WIDEST) {
            rows.startInLanes(scan, colors);
            drawRowsInLanes(band, scan, rows, colors);
        } else PlainLoops.rows(band, scan, colors);
    }

    /**
     * No depth here is −0 or NaN: the sign of {@code here − there} is their order. No red leaves 0
     * to 255, so the alpha above it stays as it is.
     */
    private static void drawRowsInLanes(
            Band band, TriangleScan scan, VectorRows rows, LinearColors colors) {
        IntVector reds = WHOLE_NUMBERS.mul(colors.stepRed);
        IntVector greens = WHOLE_NUMBERS.mul(colors.stepGreen);
        IntVector blues = WHOLE_NUMBERS.mul(colors.stepBlue);
        int nextRed = LANES * colors.stepRed;
        int nextGreen = LANES * colors.stepGreen;
        int nextBlue = LANES * colors.stepBlue;
        int[] argb = band.argb;
        float[] depth = band.depth;
        int start = band.depthStart;
        float stepZ = colors.depth.stepZ;
        for (int row = 0; row < scan.rows; row++) {
            int n = scan.count[row];
            if (n == 0) continue;
            int from = scan.cell(row);
            if (from + n + LANES > scan.end) {
                colors.at(scan, row);
                PlainLoops.linear(band, colors, from, n);
                continue;
            }
            float z = (float) rows.z[row];
            int red = (int) rows.red[row] + VectorCompact.OPAQUE;
            int green = (int) rows.green[row];
            int blue = (int) rows.blue[row];
            FloatVector column = FloatVector.fromArray(FLOATS, FIRST_NUMBERS, 0);
            for (int cell = from; cell < from + n; cell += LANES) {
                FloatVector here = column.mul(stepZ).add(z);
                FloatVector there = FloatVector.fromArray(FLOATS, depth, cell - start);
                IntVector nearer =
                        here.sub(there)
                                .reinterpretAsInts()
                                .and(column.sub(n).reinterpretAsInts())
                                .lanewise(VectorOperators.ASHR, Integer.SIZE - 1);
                column = column.add(NEXT);
                IntVector far = there.reinterpretAsInts();
                far.lanewise(VectorOperators.XOR, here.reinterpretAsInts())
                        .and(nearer)
                        .lanewise(VectorOperators.XOR, far)
                        .reinterpretAsFloats()
                        .intoArray(depth, cell - start);
                IntVector color =
                        reds.add(red)
                                .and(0xFFFF0000)
                                .or(greens.add(green).lanewise(VectorOperators.LSHR, 8).and(0xFF00))
                                .or(blues.add(blue).lanewise(VectorOperators.LSHR, 16));
                red += nextRed;
                green += nextGreen;
                blue += nextBlue;
                IntVector before = IntVector.fromArray(INTS, argb, cell);
                before.lanewise(VectorOperators.XOR, color)
                        .and(nearer)
                        .lanewise(VectorOperators.XOR, before)
                        .intoArray(argb, cell);
            }
        }
    }

    @Override
    public void collect(
            float[] depth,
            int depthStart,
            TriangleScan scan,
            RowWeights weights,
            boolean early,
            PixelBatch batch) {
        collectInLanes(depth, depthStart, scan, weights, early, batch);
    }

    @Override
    public int findInBox(float[] depth, int depthStart, int width, TriangleScan scan, RowDepth at) {
        boolean fits = scan.boxLeft + RowDepth.columns(scan) <= width;
        if (!at.gentle || !fits) return NOT_SOUGHT;
        return compact.find(depth, depthStart, width, scan, at);
    }

    @Override
    public void addFound(int width, TriangleScan scan, RowWeights weights, PixelBatch batch) {
        compact.addFound(width, scan, weights, batch);
    }

    @Override
    public void collect(
            float[] depth,
            int depthStart,
            int width,
            TinyScan scan,
            ScreenVertices v,
            boolean early,
            PixelBatch batch) {
        boolean few = scan.columns * scan.rows <= TinyScan.FEW;
        if (few || !early || scan.left + LANES > width)
            plain.collect(depth, depthStart, width, scan, v, early, batch);
        else tiny.collect(depth, depthStart, width, scan, v, batch);
    }

    /** One loop over the eights of all rows, since most rows are short. */
    private static void collectInLanes(
            float[] depth,
            int depthStart,
            TriangleScan scan,
            RowWeights weights,
            boolean early,
            PixelBatch batch) {
        float stepZ = weights.depth.stepZ;
        float toB = weights.toB;
        float toC = weights.toC;
        int kept = batch.count;
        int row = weights.row;
        int done = weights.done;
        int found = -1;
        while (row < scan.rows && kept + LANES <= PixelBatch.SIZE) {
            int left = scan.count[row] - done;
            if (left > 0) {
                if (row != found) weights.at(scan, row);
                found = row;
                int cell = scan.cell(row) + done;
                boolean all = false;
                boolean any = true;
                if (cell + LANES <= scan.end) {
                    FloatVector k = NUMBERS.add((float) (weights.depth.first + done));
                    FloatVector here = k.mul(stepZ).add(weights.depth.z);
                    FloatVector there = FloatVector.fromArray(FLOATS, depth, cell - depthStart);
                    VectorMask<Float> nearer = here.compare(VectorOperators.LT, there);
                    VectorMask<Float> beyond = NUMBERS.compare(VectorOperators.GE, (float) left);
                    all = nearer.or(beyond).allTrue();
                    if (all) {
                        if (early) here.blend(there, beyond).intoArray(depth, cell - depthStart);
                        else here.intoArray(batch.depth, kept);
                        WHOLE_NUMBERS.add(cell).intoArray(batch.cell, kept);
                        FloatVector column = NUMBERS.add((float) (weights.first + done));
                        column.mul(toB).add(weights.rowB).intoArray(batch.weightB, kept);
                        column.mul(toC).add(weights.rowC).intoArray(batch.weightC, kept);
                        kept += Math.min(LANES, left);
                    } else any = nearer.anyTrue();
                }
                if (!all && any) {
                    batch.count = kept;
                    int few = Math.min(LANES, left);
                    PlainLoops.collect(depth, depthStart, weights, cell, done, few, early, batch);
                    kept = batch.count;
                }
            }
            done += LANES;
            if (left <= LANES) {
                row++;
                done = 0;
            }
        }
        weights.row = row;
        weights.done = done;
        batch.count = kept;
    }

    @Override
    public void between(PixelBatch batch, float[][] to, float[] corners, int n, int first) {
        int k = 0;
        for (; k + 3 <= n; k += 3)
            threeInLanes(batch, first, to[k], to[k + 1], to[k + 2], corners, k);
        for (; k < n; k++)
            oneInLanes(
                    batch, first, to[k], corners[k], corners[VALUES + k], corners[2 * VALUES + k]);
    }

    private static void oneInLanes(
            PixelBatch batch, int first, float[] to, float a, float b, float c) {
        for (int i = first; i < batch.count; i += LANES)
            FloatVector.fromArray(FLOATS, batch.weightB, i)
                    .mul(b)
                    .add(a)
                    .add(FloatVector.fromArray(FLOATS, batch.weightC, i).mul(c))
                    .intoArray(to, i);
    }

    /** Three at a time read the weights once. */
    private static void threeInLanes(
            PixelBatch batch,
            int first,
            float[] to0,
            float[] to1,
            float[] to2,
            float[] corners,
            int at) {
        float a0 = corners[at];
        float a1 = corners[at + 1];
        float a2 = corners[at + 2];
        float b0 = corners[VALUES + at];
        float b1 = corners[VALUES + at + 1];
        float b2 = corners[VALUES + at + 2];
        float c0 = corners[2 * VALUES + at];
        float c1 = corners[2 * VALUES + at + 1];
        float c2 = corners[2 * VALUES + at + 2];
        for (int i = first; i < batch.count; i += LANES) {
            FloatVector b = FloatVector.fromArray(FLOATS, batch.weightB, i);
            FloatVector c = FloatVector.fromArray(FLOATS, batch.weightC, i);
            b.mul(b0).add(a0).add(c.mul(c0)).intoArray(to0, i);
            b.mul(b1).add(a1).add(c.mul(c1)).intoArray(to1, i);
            b.mul(b2).add(a2).add(c.mul(c2)).intoArray(to2, i);
        }
    }

    @Override
    public void squareSteps(PixelBatch batch, int width, int height, float[] squaredSteps) {
        squareStepsInLanes(
                batch.slopes,
                batch.values(TEXTURE_S),
                batch.values(TEXTURE_T),
                batch.nearness,
                width,
                height,
                squaredSteps);
    }

    /** What is written beyond a run is written again by the next. */
    private static void squareStepsInLanes(
            PixelSlopes slopes,
            float[] s,
            float[] t,
            float[] w,
            int width,
            int height,
            float[] squaredSteps) {
        float[] ofRightS = slopes.right(TEXTURE_S);
        float[] ofRightT = slopes.right(TEXTURE_T);
        float[] ofDownS = slopes.down(TEXTURE_S);
        float[] ofDownT = slopes.down(TEXTURE_T);
        int i = 0;
        for (int run = 0; run < slopes.runs; run++) {
            float rightS = ofRightS[run] * width;
            float rightT = ofRightT[run] * height;
            float downS = ofDownS[run] * width;
            float downT = ofDownT[run] * height;
            float rightS1 = -slopes.nearnessRight[run] * width;
            float rightT1 = -slopes.nearnessRight[run] * height;
            float downS1 = -slopes.nearnessDown[run] * width;
            float downT1 = -slopes.nearnessDown[run] * height;
            int end = slopes.end[run];
            for (; i < end; i += LANES) {
                FloatVector here = FloatVector.fromArray(FLOATS, s, i);
                FloatVector ux = here.mul(rightS1).add(rightS);
                FloatVector uy = here.mul(downS1).add(downS);
                FloatVector there = FloatVector.fromArray(FLOATS, t, i);
                FloatVector vx = there.mul(rightT1).add(rightT);
                FloatVector vy = there.mul(downT1).add(downT);
                FloatVector right = ux.mul(ux).add(vx.mul(vx));
                FloatVector down = uy.mul(uy).add(vy.mul(vy));
                FloatVector far = FloatVector.fromArray(FLOATS, w, i);
                right.blend(down, right.compare(VectorOperators.LT, down))
                        .mul(far)
                        .mul(far)
                        .intoArray(squaredSteps, i);
            }
            i = end;
        }
    }

    @Override
    public void pack(PixelBatch batch, float[] red, float[] green, float[] blue) {
        packInLanes(batch.count, red, green, blue, batch.argb);
    }

    private static void packInLanes(int n, float[] red, float[] green, float[] blue, int[] argb) {
        for (int i = 0; i < n; i += LANES)
            level(red, i)
                    .lanewise(VectorOperators.LSHL, 16)
                    .or(level(green, i).lanewise(VectorOperators.LSHL, 8))
                    .or(level(blue, i))
                    .or(0xFF000000)
                    .intoArray(argb, i);
    }

    /** The nearest level in the lowest bits, as {@link SmoothFill#argb} finds it. */
    private static IntVector level(float[] share, int i) {
        return FloatVector.fromArray(FLOATS, share, i)
                .mul(255)
                .add(SmoothFill.ROUND)
                .reinterpretAsInts();
    }
}
