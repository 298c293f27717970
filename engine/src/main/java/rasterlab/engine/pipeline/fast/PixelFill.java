package rasterlab.engine.pipeline.fast;

import java.util.Arrays;
import rasterlab.engine.scene.VertexQuantity;

/**
 * Pixels that are nearer than what is there, collected with all that lies between the vertices, and
 * coloured many at a time.
 *
 * <p>A later pixel at the same place comes later in the batch, so the nearest is written last. One
 * per thread.
 */
final class PixelFill {
    private final Band band;
    private final PixelBatch batch = new PixelBatch();
    private final RowWeights weights = new RowWeights();

    private final float[][] values = new float[FrameState.QUANTITIES.length][];
    private final boolean[] affine = new boolean[FrameState.QUANTITIES.length];
    private final boolean[] divided = new boolean[FrameState.QUANTITIES.length];

    /** The values that grow from corner to corner, and how, see {@link RowLoops#between}. */
    private final float[][] growing = new float[RowLoops.VALUES][];

    private final float[] corners = new float[3 * RowLoops.VALUES];
    private FrameState frame;
    private PixelColors colors;
    private Blending blending;
    private int count;
    private int firstFlat;

    /** Whether any value is divided by 1/w. */
    private boolean divides;

    /** Whether an alpha is wanted that counts for nothing. */
    private boolean wholeAlpha;

    /** Depths of nothing, as many as are there to be tested. */
    private float[] nothing = {};

    /** Whether the batch may still know of pixels from behind. */
    private boolean fromBehind;

    PixelFill(Band band) {
        this.band = band;
    }

    /** Forgets what a frame left behind that failed. */
    void begin(FrameState frame) {
        this.frame = frame;
        var surface = (Surface.PerPixel) frame.surface;
        colors = surface.colors();
        blending = surface.blending();
        batch.begin(colors);
        batch.slopes.begin(frame, colors);
        batch.opaque = blending.early();
        wholeAlpha = batch.opaque && colors.wants().contains(VertexQuantity.ALPHA);
        count = frame.attributeCount;
        firstFlat = count;
        divides = false;
        for (int k = count - 1; k >= 0; k--) {
            VertexQuantity quantity = frame.attribute[k];
            values[k] = batch.values(quantity);
            affine[k] = colors.affine().contains(quantity);
            divided[k] = !affine[k] && !colors.directions().contains(quantity);
            if (frame.flatColors && FrameState.isColor(quantity)) firstFlat = k;
            else divides |= divided[k];
        }
        System.arraycopy(values, 0, growing, 0, firstFlat);
        if (divides) growing[firstFlat] = batch.nearness;
    }

    /** Drops the frame's colours. */
    void end() {
        colors = null;
    }

    /**
     * @param third the vertex that has the colour of a flat triangle
     */
    void fill(TriangleScan scan, ScreenVertices v, int third) {
        float[] depth = testedDepth();
        weights.load(scan, v);
        scan.scan();
        while (weights.row < scan.rows) {
            if (batch.count == PixelBatch.SIZE) flush();
            int first = batch.count;
            RowLoops.collect(depth, band.depthStart, scan, weights, blending.early(), batch);
            interpolate(scan, v, third, first);
        }
    }

    /**
     * @param third the vertex that has the colour of a flat triangle
     */
    void fill(TinyScan scan, ScreenVertices v, int third) {
        if (batch.count + scan.columns * scan.rows > PixelBatch.SIZE) flush();
        int first = batch.count;
        RowLoops.collect(
                testedDepth(), band.depthStart, band.width, scan, v, blending.early(), batch);
        interpolate(scan, v, third, first);
    }

    /** The depths that pixels are tested against: where none is, of something infinitely far. */
    private float[] testedDepth() {
        if (blending.testsDepth()) return band.depth;
        if (nothing.length < band.depth.length) {
            nothing = new float[band.depth.length];
            Arrays.fill(nothing, Float.POSITIVE_INFINITY);
        }
        return nothing;
    }

    /** Values divided by w are linear on the picture: for the batch's pixels from {@code first}. */
    private void interpolate(Scan scan, ScreenVertices v, int third, int first) {
        if (batch.count == first) return;
        if (fromBehind || scan.fromBehind) {
            fromBehind = true;
            Arrays.fill(batch.fromBehind, first, batch.count, scan.fromBehind);
        }
        findCorners(scan, v);
        RowLoops.between(batch, growing, corners, divides ? firstFlat + 1 : firstFlat, first);
        for (int k = firstFlat; k < count; k++)
            Arrays.fill(values[k], first, batch.count, v.attribute(k, third));
        batch.slopes.endRun(scan, frame, corners, firstFlat, batch.count);
    }

    /** Finds what corner a has of each value, and what b and c have more. */
    private void findCorners(Scan scan, ScreenVertices v) {
        float qa = v.nearness(scan.a);
        float qb = v.nearness(scan.b);
        float qc = v.nearness(scan.c);
        for (int k = 0; k < firstFlat; k++) {
            float a = v.attribute(k, scan.a) * (affine[k] ? 1 : qa);
            float b = v.attribute(k, scan.b) * (affine[k] ? 1 : qb);
            float c = v.attribute(k, scan.c) * (affine[k] ? 1 : qc);
            put(k, a, b - a, c - a);
        }
        if (divides) put(firstFlat, qa, qb - qa, qc - qa);
    }

    private void put(int k, float a, float b, float c) {
        corners[k] = a;
        corners[RowLoops.VALUES + k] = b;
        corners[2 * RowLoops.VALUES + k] = c;
    }

    /** Divides, colours and writes what waits. */
    void flush() {
        int n = batch.count;
        if (n == 0) return;
        if (divides) divide(n);
        if (wholeAlpha) Arrays.fill(batch.values(VertexQuantity.ALPHA), 0, n, 1);
        colors.color(batch);
        if (blending.early()) write(n);
        else blend(n);
        batch.count = 0;
        batch.slopes.runs = 0;
    }

    private void divide(int n) {
        float[] w = batch.nearness;
        for (int i = 0; i < n; i++) w[i] = 1 / w[i];
        for (int k = 0; k < firstFlat; k++) if (divided[k]) multiply(values[k], w, n);
    }

    private static void multiply(float[] values, float[] w, int n) {
        for (int i = 0; i < n; i++) values[i] *= w[i];
    }

    private void write(int n) {
        int[] argb = band.argb;
        for (int i = 0; i < n; i++) argb[batch.cell[i]] = 0xFF000000 | batch.argb[i];
    }

    /** Depth is asked again: an earlier pixel of the batch may lie before a later one. */
    private void blend(int n) {
        int[] argb = band.argb;
        float[] depth = band.depth;
        int start = band.depthStart;
        for (int i = 0; i < n; i++) {
            int cell = batch.cell[i];
            int color = batch.argb[i];
            boolean hidden = blending.testsDepth() && !(batch.depth[i] < depth[cell - start]);
            if (color >>> 24 < blending.leastAlpha() || hidden) continue;
            argb[cell] = blending.mixed() ? Blending.over(color, argb[cell]) : 0xFF000000 | color;
            if (blending.writesDepth()) depth[cell - start] = batch.depth[i];
        }
    }
}
