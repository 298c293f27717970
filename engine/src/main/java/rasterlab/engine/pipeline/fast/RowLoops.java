package rasterlab.engine.pipeline.fast;

import static rasterlab.engine.scene.VertexQuantity.TEXTURE_S;
import static rasterlab.engine.scene.VertexQuantity.TEXTURE_T;

/** The loops over rows and pixels of one triangle. */
final class RowLoops {
    /** Room for all values that grow from corner to corner: the attributes and 1/w. */
    static final int VALUES = FrameState.QUANTITIES.length + 1;

    private RowLoops() {}

    /**
     * Draws the rows that {@link TriangleScan#scan} has found of a triangle whose depth and colours
     * are linear.
     */
    static void linear(Band band, TriangleScan scan, LinearColors colors) {
        for (int row = 0; row < scan.rows; row++) {
            int n = scan.count[row];
            if (n == 0) continue;
            colors.at(scan, row);
            linear(band, colors, scan.cell(row), n);
        }
    }

    /** Fills n pixels of a row, where the colours are. */
    private static void linear(Band band, LinearColors colors, int from, int n) {
        int[] argb = band.argb;
        float[] depth = band.depth;
        int start = band.depthStart;
        float stepZ = colors.depth.stepZ;
        int stepRed = colors.stepRed;
        int stepGreen = colors.stepGreen;
        int stepBlue = colors.stepBlue;
        float z = colors.depth.z;
        int red = colors.red;
        int green = colors.green;
        int blue = colors.blue;
        float k = colors.depth.first;
        for (int i = from; i < from + n; i++) {
            float here = z + k * stepZ;
            if (here < depth[i - start]) {
                depth[i - start] = here;
                argb[i] = LinearColors.argb(red, green, blue);
            }
            k += 1;
            red += stepRed;
            green += stepGreen;
            blue += stepBlue;
        }
    }

    /**
     * Adds pixels to a batch that are nearer than what is there, from where the weights' row is,
     * until the triangle has no more or the batch is full.
     *
     * @param depthStart the cell whose depth is {@code depth[0]}
     * @param early whether their depth is written at once
     */
    static void collect(
            float[] depth,
            int depthStart,
            TriangleScan scan,
            RowWeights weights,
            boolean early,
            PixelBatch batch) {
        for (; weights.row < scan.rows; weights.row++, weights.done = 0) {
            int count = scan.count[weights.row];
            if (count == 0) continue;
            weights.at(scan, weights.row);
            while (weights.done < count) {
                int n = Math.min(count - weights.done, PixelBatch.SIZE - batch.count);
                if (n == 0) return;
                int cell = scan.cell(weights.row) + weights.done;
                collect(depth, depthStart, weights, cell, weights.done, n, early, batch);
                weights.done += n;
            }
        }
    }

    private static void collect(
            float[] depth,
            int depthStart,
            RowWeights weights,
            int from,
            int first,
            int n,
            boolean early,
            PixelBatch batch) {
        int kept = batch.count;
        float z = weights.depth.z;
        float stepZ = weights.depth.stepZ;
        float k = (float) weights.depth.first + first - 1;
        float column = (float) weights.first + first - 1;
        for (int cell = from; cell < from + n; cell++) {
            k += 1;
            column += 1;
            float here = z + k * stepZ;
            if (!(here < depth[cell - depthStart])) continue;
            if (early) depth[cell - depthStart] = here;
            else batch.depth[kept] = here;
            batch.cell[kept] = cell;
            batch.weightB[kept] = weights.rowB + column * weights.toB;
            batch.weightC[kept++] = weights.rowC + column * weights.toC;
        }
        batch.count = kept;
    }

    /**
     * Adds those pixels of a small triangle to a batch that are nearer than what is there.
     *
     * @param depthStart the cell whose depth is {@code depth[0]}
     * @param width of the picture
     * @param early whether their depth is written at once
     * @param batch with room for the whole box
     */
    static void collect(
            float[] depth,
            int depthStart,
            int width,
            TinyScan scan,
            ScreenVertices v,
            boolean early,
            PixelBatch batch) {
        scan.look(width);
        float za = v.depth(scan.a);
        float zb = v.depth(scan.b) - za;
        float zc = v.depth(scan.c) - za;
        int kept = batch.count;
        for (int k = 0; k < scan.count; k++) {
            int cell = scan.cell[k];
            float atB = scan.edgeB[k] * scan.inverseArea;
            float atC = scan.edgeC[k] * scan.inverseArea;
            float here = za + atB * zb + atC * zc;
            if (!(here < depth[cell - depthStart])) continue;
            if (early) depth[cell - depthStart] = here;
            else batch.depth[kept] = here;
            batch.cell[kept] = cell;
            batch.weightB[kept] = atB;
            batch.weightC[kept++] = atC;
        }
        batch.count = kept;
    }

    /**
     * Writes {@code a + weightB·b + weightC·c} for the batch's pixels from {@code first} on, to
     * each of n arrays.
     *
     * @param corners the a of each array, from {@link #VALUES} on the b, from twice that on the c
     */
    static void between(PixelBatch batch, float[][] to, float[] corners, int n, int first) {
        for (int k = 0; k < n; k++)
            between(batch, first, to[k], corners[k], corners[VALUES + k], corners[2 * VALUES + k]);
    }

    private static void between(
            PixelBatch batch, int first, float[] to, float a, float b, float c) {
        for (int i = first; i < batch.count; i++)
            to[i] = a + batch.weightB[i] * b + batch.weightC[i] * c;
    }

    /**
     * Finds ρ² of the batch's pixels from their texture coordinates, w and the slopes of their
     * runs.
     */
    static void squareSteps(PixelBatch batch, int width, int height, float[] squaredSteps) {
        float[] s = batch.values(TEXTURE_S);
        float[] t = batch.values(TEXTURE_T);
        float[] w = batch.nearness;
        PixelSlopes slopes = batch.slopes;
        int from = 0;
        for (int run = 0; run < slopes.runs; from = slopes.end[run++]) {
            float rightS = slopes.right(TEXTURE_S)[run] * width;
            float rightT = slopes.right(TEXTURE_T)[run] * height;
            float downS = slopes.down(TEXTURE_S)[run] * width;
            float downT = slopes.down(TEXTURE_T)[run] * height;
            float rightS1 = slopes.nearnessRight[run] * width;
            float rightT1 = slopes.nearnessRight[run] * height;
            float downS1 = slopes.nearnessDown[run] * width;
            float downT1 = slopes.nearnessDown[run] * height;
            for (int i = from; i < slopes.end[run]; i++) {
                float ux = rightS - s[i] * rightS1;
                float vx = rightT - t[i] * rightT1;
                float uy = downS - s[i] * downS1;
                float vy = downT - t[i] * downT1;
                float right = ux * ux + vx * vx;
                float down = uy * uy + vy * vy;
                squaredSteps[i] = (right < down ? down : right) * w[i] * w[i];
            }
        }
    }
}
