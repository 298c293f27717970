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

    /** The weights of a triangle's corners b and c at its pixels. */
    private final float[] weightB = new float[PixelBatch.SIZE];

    private final float[] weightC = new float[PixelBatch.SIZE];

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
        int first = batch.count;
        for (int row = 0; row < scan.rows; row++)
            for (int done = 0; done < scan.count[row]; ) {
                if (batch.count == PixelBatch.SIZE) {
                    interpolate(scan, v, first);
                    flush(out);
                    first = 0;
                }
                int n = Math.min(scan.count[row] - done, PixelBatch.SIZE - batch.count);
                collect(out, scan, v, row, done, n);
                done += n;
            }
        interpolate(scan, v, first);
    }

    /** What is nearest of the n pixels of a row from its pixel {@code first} on. */
    private void collect(
            DepthRaster out, TriangleScan scan, ScreenVertices v, int row, int first, int n) {
        float[] depth = out.depth();
        float za = v.depth[scan.a];
        float zb = v.depth[scan.b] - za;
        float zc = v.depth[scan.c] - za;
        float toB = scan.stepB * scan.inverseArea;
        float toC = scan.stepC * scan.inverseArea;
        float rowB = scan.edgeB[row] * scan.inverseArea;
        float rowC = scan.edgeC[row] * scan.inverseArea;
        float z = za + rowB * zb + rowC * zc;
        float step = toB * zb + toC * zc;
        int from = (scan.top + row) * out.width() + scan.left[row];
        int kept = batch.count;
        for (int k = first; k < first + n; k++) {
            float here = z + k * step;
            if (!(here < depth[from + k])) continue;
            depth[from + k] = here;
            batch.cell[kept] = from + k;
            weightB[kept] = rowB + k * toB;
            weightC[kept++] = rowC + k * toC;
        }
        batch.count = kept;
    }

    /** Values divided by w are linear on the picture: for the batch's pixels from {@code first}. */
    private void interpolate(TriangleScan scan, ScreenVertices v, int first) {
        if (batch.count == first) return;
        float qa = v.nearness[scan.a];
        float qb = v.nearness[scan.b];
        float qc = v.nearness[scan.c];
        between(batch.nearness, first, qa, qb - qa, qc - qa);
        for (int k = 0; k < values.length; k++) {
            float a = v.attributes[k][scan.a] * qa;
            float b = v.attributes[k][scan.b] * qb - a;
            float c = v.attributes[k][scan.c] * qc - a;
            between(values[k], first, a, b, c);
        }
    }

    private void between(float[] out, int first, float a, float b, float c) {
        for (int i = first; i < batch.count; i++) out[i] = a + weightB[i] * b + weightC[i] * c;
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
