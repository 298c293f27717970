package rasterlab.engine.pipeline.triangle;

import rasterlab.engine.scene.VertexQuantity;

/**
 * Pixels that are nearer than what is there, collected with all that lies between the vertices, and
 * coloured many at a time.
 *
 * <p>A later pixel at the same place comes later in the batch, so the nearest is written last. One
 * per thread and surface.
 */
final class PixelFill {
    private final PixelColors colors;
    private final PixelBatch batch;
    private final float[][] values;

    /** Pixels from the row's first, for those that wait. */
    private final float[] offset = new float[PixelBatch.SIZE];

    PixelFill(PixelColors colors) {
        this.colors = colors;
        batch = new PixelBatch(colors.wants());
        values = new float[colors.wants().size()][];
        int k = 0;
        for (VertexQuantity quantity : VertexQuantity.values())
            if (colors.wants().contains(quantity)) values[k++] = batch.values(quantity);
    }

    /** Whether this fill is for those colours. */
    boolean isFor(PixelColors other) {
        return colors == other;
    }

    /** Forgets what a frame left behind that failed. */
    void begin() {
        batch.count = 0;
    }

    void fill(DepthRaster out, TriangleScan scan, ScreenVertices v) {
        for (int row = 0; row < scan.rows; row++)
            for (int done = 0; done < scan.count[row]; ) {
                if (batch.count == PixelBatch.SIZE) flush(out);
                int n = Math.min(scan.count[row] - done, PixelBatch.SIZE - batch.count);
                collect(out, scan, v, row, done, n);
                done += n;
            }
    }

    /** The n pixels of a row from its pixel {@code first} on. */
    private void collect(
            DepthRaster out, TriangleScan scan, ScreenVertices v, int row, int first, int n) {
        float toB = scan.stepB * scan.inverseArea;
        float toC = scan.stepC * scan.inverseArea;
        float rowB = scan.edgeB[row] * scan.inverseArea;
        float rowC = scan.edgeC[row] * scan.inverseArea;
        int from = (scan.top + row) * out.width() + scan.left[row] + first;
        float za = v.depth[scan.a];
        float zb = v.depth[scan.b] - za;
        float zc = v.depth[scan.c] - za;
        int old = batch.count;
        test(out.depth(), from, first, n, za + rowB * zb + rowC * zc, toB * zb + toC * zc);
        if (batch.count == old) return;
        float qa = v.nearness[scan.a];
        float qb = v.nearness[scan.b];
        float qc = v.nearness[scan.c];
        float stepQ = toB * (qb - qa) + toC * (qc - qa);
        between(batch.nearness, old, qa + rowB * (qb - qa) + rowC * (qc - qa), stepQ);
        for (int k = 0; k < values.length; k++) {
            float a = v.attributes[k][scan.a] * qa;
            float b = v.attributes[k][scan.b] * qb - a;
            float c = v.attributes[k][scan.c] * qc - a;
            between(values[k], old, a + rowB * b + rowC * c, toB * b + toC * c);
        }
    }

    private void test(float[] depth, int from, int first, int n, float z, float step) {
        int kept = batch.count;
        for (int k = 0; k < n; k++) {
            float here = z + (first + k) * step;
            if (!(here < depth[from + k])) continue;
            depth[from + k] = here;
            batch.cell[kept] = from + k;
            offset[kept++] = first + k;
        }
        batch.count = kept;
    }

    private void between(float[] out, int from, float base, float step) {
        for (int i = from; i < batch.count; i++) out[i] = base + offset[i] * step;
    }

    /** Divides, colours and writes what waits. */
    void flush(DepthRaster out) {
        int n = batch.count;
        if (n == 0) return;
        for (int i = 0; i < n; i++) batch.nearness[i] = 1 / batch.nearness[i];
        for (float[] array : values) for (int i = 0; i < n; i++) array[i] *= batch.nearness[i];
        colors.color(batch);
        int[] argb = out.raster().argb();
        for (int i = 0; i < n; i++) argb[batch.cell[i]] = batch.argb[i];
        batch.count = 0;
    }
}
