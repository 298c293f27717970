package rasterlab.engine.pipeline.triangle;

/** Colours of the vertices, perspective-correct between them, on small triangles. */
final class TinyFill {
    private TinyFill() {}

    /**
     * With weights b and q = 1/w the share of corner k is {@code b_k·q_k/Σbq}; a's is what the
     * others leave.
     */
    static void smooth(DepthRaster out, TinyScan scan, ScreenVertices v) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        int a = scan.a;
        int b = scan.b;
        int c = scan.c;
        float za = v.depth[a];
        float zb = v.depth[b] - za;
        float zc = v.depth[c] - za;
        float qa = v.nearness[a];
        float qb = v.nearness[b];
        float qc = v.nearness[c];
        float ra = v.attributes[0][a];
        float rb = v.attributes[0][b] - v.attributes[0][a];
        float rc = v.attributes[0][c] - v.attributes[0][a];
        float ga = v.attributes[1][a];
        float gb = v.attributes[1][b] - v.attributes[1][a];
        float gc = v.attributes[1][c] - v.attributes[1][a];
        float ba = v.attributes[2][a];
        float bb = v.attributes[2][b] - v.attributes[2][a];
        float bc = v.attributes[2][c] - v.attributes[2][a];
        for (int k = 0; k < scan.count; k++) {
            int cell = scan.cell[k];
            float weightB = scan.edgeB[k] * scan.inverseArea;
            float weightC = scan.edgeC[k] * scan.inverseArea;
            float here = za + weightB * zb + weightC * zc;
            if (!(here < depth[cell])) continue;
            depth[cell] = here;
            float w = 1 / (qa + weightB * (qb - qa) + weightC * (qc - qa));
            float shareB = weightB * qb * w;
            float shareC = weightC * qc * w;
            argb[cell] =
                    SmoothFill.argb(
                            ra + shareB * rb + shareC * rc,
                            ga + shareB * gb + shareC * gc,
                            ba + shareB * bb + shareC * bc);
        }
    }

    static void flat(DepthRaster out, TinyScan scan, ScreenVertices v, int color) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        float za = v.depth[scan.a];
        float zb = v.depth[scan.b] - za;
        float zc = v.depth[scan.c] - za;
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
