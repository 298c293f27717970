package rasterlab.engine.pipeline.triangle;

/** Colours of the vertices, perspective-correct between them, on small triangles. */
final class TinyFill {
    private TinyFill() {}

    /**
     * With weights b and q = 1/w the share of corner k is {@code b_k·q_k/Σbq}; a's is what the
     * others leave.
     */
    static void smooth(DepthRaster out, TinyScan scan, SmoothCorners at) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        for (int k = 0; k < scan.count; k++) {
            int cell = scan.cell[k];
            float weightB = scan.edgeB[k] * at.inverseArea;
            float weightC = scan.edgeC[k] * at.inverseArea;
            float here = at.za + weightB * at.zb + weightC * at.zc;
            if (!(here < depth[cell])) continue;
            depth[cell] = here;
            float w = 1 / (at.qa + weightB * at.qb + weightC * at.qc);
            float shareB = weightB * at.ofB * w;
            float shareC = weightC * at.ofC * w;
            argb[cell] =
                    SmoothFill.argb(
                            at.ra + shareB * at.rb + shareC * at.rc,
                            at.ga + shareB * at.gb + shareC * at.gc,
                            at.ba + shareB * at.bb + shareC * at.bc);
        }
    }

    static void flat(DepthRaster out, TinyScan scan, ScreenVertices v, int color) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        float za = v.depth(scan.a);
        float zb = v.depth(scan.b) - za;
        float zc = v.depth(scan.c) - za;
        for (int k = 0; k < scan.count; k++) {
            int cell = scan.cell[k];
            float weightB = scan.edgeB[k] * scan.inverseArea;
            float weightC = scan.edgeC[k] * scan.inverseArea;
            float here = za + weightB * zb + weightC * zc;
            if (!(here < depth[cell])) continue;
            depth[cell] = here;
            argb[cell] = color;
        }
    }
}
