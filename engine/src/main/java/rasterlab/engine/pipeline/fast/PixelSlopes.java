package rasterlab.engine.pipeline.fast;

import java.util.Arrays;
import rasterlab.engine.scene.VertexQuantity;

/**
 * How fast values grow on the picture, exactly, at the centre of each pixel of a batch.
 *
 * <p>With v = n/q, n and q = 1/w linear on the picture, {@code dv/dx = (dn/dx − v·dq/dx)·w}. What
 * is affine has the slope dn/dx. Slopes of n and q are the same in all pixels of a triangle, which
 * are a run of the batch: they are kept once for each run. One per thread.
 */
final class PixelSlopes {
    /** How many runs the batch has. */
    int runs;

    /** The pixel after each run's last. */
    final int[] end = new int[PixelBatch.SIZE];

    /** The growth of 1/w to the right and down, in each run. */
    final float[] nearnessRight = new float[PixelBatch.SIZE];

    final float[] nearnessDown = new float[PixelBatch.SIZE];

    private final float[][] right = new float[FrameState.QUANTITIES.length][];
    private final float[][] down = new float[FrameState.QUANTITIES.length][];
    private final boolean[] affine = new boolean[FrameState.QUANTITIES.length];

    /** The attributes whose slopes are wanted. */
    private final int[] attribute = new int[FrameState.QUANTITIES.length];

    private int count;

    void begin(FrameState frame, PixelColors colors) {
        count = 0;
        runs = 0;
        for (int k = 0; k < frame.attributeCount; k++) {
            VertexQuantity quantity = frame.attribute[k];
            if (!colors.wantsSlopes().contains(quantity)) continue;
            int place = quantity.ordinal();
            if (right[place] == null) {
                right[place] = new float[PixelBatch.SIZE];
                down[place] = new float[PixelBatch.SIZE];
            }
            affine[place] = colors.affine().contains(quantity);
            attribute[count++] = k;
        }
    }

    /**
     * Ends a run: the batch's pixels since the last one are of one triangle.
     *
     * @param corners of its values, as {@link RowLoops#between} has them
     * @param nearness where 1/w is among them
     */
    void endRun(Scan scan, FrameState frame, float[] corners, int nearness, int pixels) {
        if (count == 0) return;
        float rightB = scan.stepB * scan.inverseArea;
        float rightC = scan.stepC * scan.inverseArea;
        float downB = scan.downB * scan.inverseArea;
        float downC = scan.downC * scan.inverseArea;
        end[runs] = pixels;
        float b = corners[RowLoops.VALUES + nearness];
        float c = corners[2 * RowLoops.VALUES + nearness];
        nearnessRight[runs] = rightB * b + rightC * c;
        nearnessDown[runs] = downB * b + downC * c;
        for (int k = 0; k < count; k++) {
            int place = frame.attribute[attribute[k]].ordinal();
            b = corners[RowLoops.VALUES + attribute[k]];
            c = corners[2 * RowLoops.VALUES + attribute[k]];
            right[place][runs] = rightB * b + rightC * c;
            down[place][runs] = downB * b + downC * c;
        }
        runs++;
    }

    /** The growth of n to the right in each run. */
    float[] right(VertexQuantity quantity) {
        return right[quantity.ordinal()];
    }

    /** The growth of a quantity downward. */
    float[] down(VertexQuantity quantity) {
        return down[quantity.ordinal()];
    }

    /** Finds the slopes of a value to the right. */
    void findRight(VertexQuantity quantity, float[] value, float[] w, float[] slope) {
        find(right(quantity), nearnessRight, affine[quantity.ordinal()], value, w, slope);
    }

    void findDown(VertexQuantity quantity, float[] value, float[] w, float[] slope) {
        find(down(quantity), nearnessDown, affine[quantity.ordinal()], value, w, slope);
    }

    private void find(
            float[] ofRun,
            float[] ofNearness,
            boolean linear,
            float[] value,
            float[] w,
            float[] slope) {
        int from = 0;
        for (int run = 0; run < runs; from = end[run++])
            if (linear) Arrays.fill(slope, from, end[run], ofRun[run]);
            else
                for (int i = from; i < end[run]; i++)
                    slope[i] = (ofRun[run] - value[i] * ofNearness[run]) * w[i];
    }
}
