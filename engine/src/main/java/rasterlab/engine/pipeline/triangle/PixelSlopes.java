package rasterlab.engine.pipeline.triangle;

import java.util.Arrays;
import rasterlab.engine.scene.VertexQuantity;

/**
 * How fast values grow on the picture, exactly, at the centre of each pixel of a batch.
 *
 * <p>With v = n/q, n and q = 1/w linear on the picture, {@code dv/dx = (dn/dx − v·dq/dx)·w}. What
 * is affine has the slope dn/dx. One per thread.
 */
final class PixelSlopes {
    private final PixelBatch batch;
    private final int[] attribute = new int[Frame.QUANTITIES.length];
    private final float[][] right = new float[Frame.QUANTITIES.length][];
    private final float[][] down = new float[Frame.QUANTITIES.length][];
    private final boolean[] affine = new boolean[Frame.QUANTITIES.length];
    private int count;

    PixelSlopes(PixelBatch batch) {
        this.batch = batch;
    }

    void begin(Frame frame, PixelColors colors) {
        count = 0;
        for (int k = 0; k < frame.attributeCount; k++) {
            VertexQuantity quantity = frame.attribute[k];
            if (!colors.wantsSlopes().contains(quantity)) continue;
            attribute[count] = k;
            right[count] = batch.right(quantity);
            down[count] = batch.down(quantity);
            affine[count++] = colors.affine().contains(quantity);
        }
    }

    /** dn/dx and dq/dx for the batch's pixels from {@code first}, all of one triangle. */
    void interpolate(Scan scan, ScreenVertices v, int first) {
        if (count == 0) return;
        float rightB = scan.stepB * scan.inverseArea;
        float rightC = scan.stepC * scan.inverseArea;
        float downB = scan.downB * scan.inverseArea;
        float downC = scan.downC * scan.inverseArea;
        float qa = v.nearness(scan.a);
        float qb = v.nearness(scan.b);
        float qc = v.nearness(scan.c);
        Arrays.fill(
                batch.nearnessRight, first, batch.count, rightB * (qb - qa) + rightC * (qc - qa));
        Arrays.fill(batch.nearnessDown, first, batch.count, downB * (qb - qa) + downC * (qc - qa));
        for (int k = 0; k < count; k++) {
            int of = attribute[k];
            float a = v.attribute(of, scan.a) * (affine[k] ? 1 : qa);
            float b = v.attribute(of, scan.b) * (affine[k] ? 1 : qb) - a;
            float c = v.attribute(of, scan.c) * (affine[k] ? 1 : qc) - a;
            Arrays.fill(right[k], first, batch.count, rightB * b + rightC * c);
            Arrays.fill(down[k], first, batch.count, downB * b + downC * c);
        }
    }

    /**
     * @param values of the attributes, divided already
     */
    void divide(float[][] values, int n) {
        for (int k = 0; k < count; k++) {
            if (affine[k]) continue;
            divide(right[k], values[attribute[k]], batch.nearnessRight, n);
            divide(down[k], values[attribute[k]], batch.nearnessDown, n);
        }
    }

    private void divide(float[] slope, float[] value, float[] ofNearness, int n) {
        float[] w = batch.nearness;
        for (int i = 0; i < n; i++) slope[i] = (slope[i] - value[i] * ofNearness[i]) * w[i];
    }
}
