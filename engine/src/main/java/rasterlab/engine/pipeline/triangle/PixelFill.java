package rasterlab.engine.pipeline.triangle;

import rasterlab.engine.scene.VertexQuantity;

/**
 * Pixels that are nearer than what is there, collected with all that lies between the vertices, and
 * coloured many at a time.
 *
 * <p>A later pixel at the same place comes later in the batch, so the nearest is written last. One
 * per thread.
 */
final class PixelFill {
    private final PixelBatch batch = new PixelBatch();
    private final PixelSlopes slopes = new PixelSlopes(batch);

    /** The weights of a triangle's corners b and c at its pixels. */
    private final float[] weightB = new float[PixelBatch.SIZE];

    private final float[] weightC = new float[PixelBatch.SIZE];

    private final float[][] values = new float[Frame.QUANTITIES.length][];
    private final boolean[] affine = new boolean[Frame.QUANTITIES.length];
    private DepthRaster out;
    private PixelColors colors;
    private Blending blending;
    private int count;
    private int firstFlat;

    /** Forgets what a frame left behind that failed. */
    void begin(Frame frame) {
        var surface = (Surface.PerPixel) frame.surface;
        out = frame.out;
        colors = surface.colors();
        blending = surface.blending();
        batch.begin(colors);
        slopes.begin(frame, colors);
        count = frame.attributeCount;
        firstFlat = count;
        for (int k = count - 1; k >= 0; k--) {
            VertexQuantity quantity = frame.attribute[k];
            values[k] = batch.values(quantity);
            affine[k] = colors.affine().contains(quantity);
            if (frame.flatColors && Frame.isColor(quantity)) firstFlat = k;
        }
    }

    /**
     * @param third the vertex that has the colour of a flat triangle
     */
    void fill(TriangleScan scan, ScreenVertices v, int third) {
        int first = batch.count;
        for (int row = 0; row < scan.rows; row++)
            for (int done = 0; done < scan.count[row]; ) {
                if (batch.count == PixelBatch.SIZE) {
                    interpolate(scan, v, third, first);
                    flush();
                    first = 0;
                }
                int n = Math.min(scan.count[row] - done, PixelBatch.SIZE - batch.count);
                collect(scan, v, row, done, n);
                done += n;
            }
        interpolate(scan, v, third, first);
    }

    /**
     * @param third the vertex that has the colour of a flat triangle
     */
    void fill(TinyScan scan, ScreenVertices v, int third) {
        if (batch.count + scan.count > PixelBatch.SIZE) flush();
        int first = batch.count;
        collect(scan, v);
        interpolate(scan, v, third, first);
    }

    private void collect(TinyScan scan, ScreenVertices v) {
        boolean early = blending.early();
        boolean tests = blending.testsDepth();
        float[] depth = out.depth();
        float za = v.depth[scan.a];
        float zb = v.depth[scan.b] - za;
        float zc = v.depth[scan.c] - za;
        int kept = batch.count;
        for (int k = 0; k < scan.count; k++) {
            int cell = scan.cell[k];
            float atB = scan.edgeB[k] * scan.inverseArea;
            float atC = scan.edgeC[k] * scan.inverseArea;
            float here = za + atB * zb + atC * zc;
            if (!(here < depth[cell]) && tests) continue;
            if (early) depth[cell] = here;
            else batch.depth[kept] = here;
            batch.cell[kept] = cell;
            weightB[kept] = atB;
            weightC[kept++] = atC;
        }
        batch.count = kept;
    }

    /** What is nearest of the n pixels of a row from its pixel {@code first} on. */
    private void collect(TriangleScan scan, ScreenVertices v, int row, int first, int n) {
        boolean early = blending.early();
        boolean tests = blending.testsDepth();
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
        int from = (scan.top + row) * out.width() + scan.left[row] + first;
        int kept = batch.count;
        float k = first - 1;
        for (int cell = from; cell < from + n; cell++) {
            k += 1;
            float here = z + k * step;
            if (!(here < depth[cell]) && tests) continue;
            if (early) depth[cell] = here;
            else batch.depth[kept] = here;
            batch.cell[kept] = cell;
            weightB[kept] = rowB + k * toB;
            weightC[kept++] = rowC + k * toC;
        }
        batch.count = kept;
    }

    /** Values divided by w are linear on the picture: for the batch's pixels from {@code first}. */
    private void interpolate(Scan scan, ScreenVertices v, int third, int first) {
        if (batch.count == first) return;
        float qa = v.nearness[scan.a];
        float qb = v.nearness[scan.b];
        float qc = v.nearness[scan.c];
        between(batch.nearness, first, qa, qb - qa, qc - qa);
        for (int i = first; i < batch.count; i++) batch.fromBehind[i] = scan.fromBehind;
        for (int k = 0; k < firstFlat; k++) {
            float a = v.attributes[k][scan.a] * (affine[k] ? 1 : qa);
            float b = v.attributes[k][scan.b] * (affine[k] ? 1 : qb) - a;
            float c = v.attributes[k][scan.c] * (affine[k] ? 1 : qc) - a;
            between(values[k], first, a, b, c);
        }
        for (int k = firstFlat; k < count; k++) {
            float value = v.attributes[k][third];
            for (int i = first; i < batch.count; i++) values[k][i] = value;
        }
        slopes.interpolate(scan, v, first);
    }

    private void between(float[] to, int first, float a, float b, float c) {
        for (int i = first; i < batch.count; i++) to[i] = a + weightB[i] * b + weightC[i] * c;
    }

    /** Divides, colours and writes what waits. */
    void flush() {
        int n = batch.count;
        if (n == 0) return;
        float[] w = batch.nearness;
        for (int i = 0; i < n; i++) w[i] = 1 / w[i];
        for (int k = 0; k < firstFlat; k++) if (!affine[k]) multiply(values[k], w, n);
        slopes.divide(values, n);
        colors.color(batch);
        if (blending.early()) write(n);
        else blend(n);
        batch.count = 0;
    }

    private static void multiply(float[] values, float[] w, int n) {
        for (int i = 0; i < n; i++) values[i] *= w[i];
    }

    private void write(int n) {
        int[] argb = out.raster().argb();
        for (int i = 0; i < n; i++) argb[batch.cell[i]] = 0xFF000000 | batch.argb[i];
    }

    /** Depth is asked again: an earlier pixel of the batch may lie before a later one. */
    private void blend(int n) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        for (int i = 0; i < n; i++) {
            int cell = batch.cell[i];
            int color = batch.argb[i];
            boolean hidden = blending.testsDepth() && !(batch.depth[i] < depth[cell]);
            if (color >>> 24 < blending.leastAlpha() || hidden) continue;
            argb[cell] = blending.mixed() ? Blending.over(color, argb[cell]) : 0xFF000000 | color;
            if (blending.writesDepth()) depth[cell] = batch.depth[i];
        }
    }
}
