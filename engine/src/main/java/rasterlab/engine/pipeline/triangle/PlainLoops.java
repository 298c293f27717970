package rasterlab.engine.pipeline.triangle;

import java.util.Arrays;
import rasterlab.engine.lanes.Lanes;

/** One pixel after the other. */
final class PlainLoops implements RowLoops {
    private final SmoothCorners corners = new SmoothCorners();

    @Override
    public Lanes lanes() {
        return Lanes.ONE;
    }

    @Override
    public void scan(TriangleScan scan) {
        scan.scan();
    }

    @Override
    public void smooth(DepthRaster out, TinyScan scan, ScreenVertices v) {
        scan.look(out.width());
        if (scan.count == 0) return;
        corners.load(scan, v);
        TinyFill.smooth(out, scan, corners);
    }

    @Override
    public void linear(DepthRaster out, TriangleScan scan, LinearColors colors) {
        scan.scan();
        for (int row = 0; row < scan.rows; row++) {
            int n = scan.count[row];
            if (n == 0) continue;
            colors.at(scan, row);
            linear(out, colors, scan.cell(row), n);
        }
    }

    /** n pixels of a row, where the colours are. */
    static void linear(DepthRaster out, LinearColors colors, int from, int n) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
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
            if (here < depth[i]) {
                depth[i] = here;
                argb[i] = LinearColors.argb(red, green, blue);
            }
            k += 1;
            red += stepRed;
            green += stepGreen;
            blue += stepBlue;
        }
    }

    @Override
    public void collect(
            float[] depth,
            TriangleScan scan,
            RowWeights weights,
            int cell,
            int first,
            int n,
            boolean early,
            PixelBatch batch) {
        collect(depth, weights, cell, first, n, early, batch);
    }

    static void collect(
            float[] depth,
            RowWeights weights,
            int from,
            int first,
            int n,
            boolean early,
            PixelBatch batch) {
        int kept = batch.count;
        float z = weights.depth.z;
        float stepZ = weights.depth.stepZ;
        float start = weights.depth.first;
        float k = first - 1;
        for (int cell = from; cell < from + n; cell++) {
            k += 1;
            float here = z + (start + k) * stepZ;
            if (!(here < depth[cell])) continue;
            if (early) depth[cell] = here;
            else batch.depth[kept] = here;
            batch.cell[kept] = cell;
            batch.weightB[kept] = weights.rowB + k * weights.toB;
            batch.weightC[kept++] = weights.rowC + k * weights.toC;
        }
        batch.count = kept;
    }

    @Override
    public void between(PixelBatch batch, float[] to, int first, float a, float b, float c) {
        interpolate(batch, to, first, a, b, c);
    }

    static void interpolate(PixelBatch batch, float[] to, int first, float a, float b, float c) {
        for (int i = first; i < batch.count; i++)
            to[i] = a + batch.weightB[i] * b + batch.weightC[i] * c;
    }

    @Override
    public void fill(PixelBatch batch, float[] to, int first, float value) {
        Arrays.fill(to, first, batch.count, value);
    }

    @Override
    public void pack(PixelBatch batch, float[] red, float[] green, float[] blue) {
        PixelLevels.pack(batch.count, red, green, blue, batch.argb);
    }
}
