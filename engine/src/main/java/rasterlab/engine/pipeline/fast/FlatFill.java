package rasterlab.engine.pipeline.fast;

/** One colour for a triangle. */
final class FlatFill {
    private FlatFill() {}

    /** An opaque colour from the vertex's channels of 0 to 255. */
    static int argb(ScreenVertices v, int vertex) {
        int red = (int) (v.attribute(0, vertex) + 0.5f);
        int green = (int) (v.attribute(1, vertex) + 0.5f);
        int blue = (int) (v.attribute(2, vertex) + 0.5f);
        return 0xFF000000 | red << 16 | green << 8 | blue;
    }

    static void fill(
            Band band, TriangleScan scan, ScreenVertices v, RowWeights weights, int color) {
        int[] argb = band.argb;
        float[] depth = band.depth;
        int start = band.depthStart;
        weights.load(scan, v);
        float stepZ = weights.depth.stepZ;
        for (int row = 0; row < scan.rows; row++) {
            int from = scan.cell(row);
            int to = from + scan.count[row];
            weights.at(scan, row);
            float z = weights.depth.z;
            float k = weights.depth.first;
            for (int i = from; i < to; i++) {
                float here = z + k * stepZ;
                if (here < depth[i - start]) {
                    depth[i - start] = here;
                    argb[i] = color;
                }
                k += 1;
            }
        }
    }
}
