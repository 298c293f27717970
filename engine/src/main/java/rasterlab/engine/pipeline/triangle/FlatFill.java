package rasterlab.engine.pipeline.triangle;

/** One colour for a triangle. */
final class FlatFill {
    private FlatFill() {}

    /** An opaque colour from channels of 0 to 255. */
    static int argb(float[][] rgb, int vertex) {
        int red = (int) (rgb[0][vertex] + 0.5f);
        int green = (int) (rgb[1][vertex] + 0.5f);
        int blue = (int) (rgb[2][vertex] + 0.5f);
        return 0xFF000000 | red << 16 | green << 8 | blue;
    }

    static void fill(DepthRaster out, TriangleScan scan, ScreenVertices v, int color) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        float base = v.depth[scan.a];
        float perB = (v.depth[scan.b] - base) * scan.inverseArea;
        float perC = (v.depth[scan.c] - base) * scan.inverseArea;
        float step = scan.stepB * perB + scan.stepC * perC;
        for (int row = 0; row < scan.rows; row++) {
            int from = scan.cell(row);
            int to = from + scan.count[row];
            float z = base + (float) scan.edgeB[row] * perB + (float) scan.edgeC[row] * perC;
            float k = 0;
            for (int i = from; i < to; i++) {
                float here = z + k * step;
                if (here < depth[i]) {
                    depth[i] = here;
                    argb[i] = color;
                }
                k += 1;
            }
        }
    }
}
