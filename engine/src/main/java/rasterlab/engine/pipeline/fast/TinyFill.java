package rasterlab.engine.pipeline.fast;

/** Colours of the vertices, perspective-correct between them, on small triangles. */
final class TinyFill {
    private TinyFill() {}

    /**
     * Draws with weights b and q = 1/w: the share of corner k is {@code b_k·q_k/Σbq}; a's is what
     * the others leave.
     */
    static void smooth(Band band, TinyScan scan, SmoothCorners at) {
        int[] argb = band.argb;
        float[] depth = band.depth;
        int start = band.depthStart;
        for (int k = 0; k < scan.count; k++) {
            int cell = scan.cell[k];
            float weightB = scan.edgeB[k] * at.inverseArea;
            float weightC = scan.edgeC[k] * at.inverseArea;
            float here = at.za + weightB * at.zb + weightC * at.zc;
            if (!(here < depth[cell - start])) continue;
            depth[cell - start] = here;
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

    /** Fills a box of so few pixels that nothing is prepared for the next one. */
    static void few(Band band, TinyScan scan, ScreenVertices v) {
        int[] argb = band.argb;
        float[] depth = band.depth;
        int start = band.depthStart;
        float inverseArea = scan.inverseArea;
        int stepA = scan.stepA;
        int stepB = (int) scan.stepB;
        int stepC = (int) scan.stepC;
        int ownB = scan.ownB;
        int ownC = scan.ownC;
        float za = v.depth(scan.a);
        float zb = v.depth(scan.b) - za;
        float zc = v.depth(scan.c) - za;
        for (int row = 0; row < scan.rows; row++) {
            int eA = scan.rowA + row * scan.downA;
            int eB = scan.rowB + row * (int) scan.downB;
            int eC = scan.rowC + row * (int) scan.downC;
            int cell = scan.at + row * band.width;
            for (int end = cell + scan.columns; cell < end; cell++) {
                if ((eA | eB + ownB | eC + ownC) >= 0) {
                    float weightB = eB * inverseArea;
                    float weightC = eC * inverseArea;
                    float here = za + weightB * zb + weightC * zc;
                    if (here < depth[cell - start]) {
                        depth[cell - start] = here;
                        argb[cell] = color(v, scan.a, scan.b, scan.c, weightB, weightC);
                    }
                }
                eA += stepA;
                eB += stepB;
                eC += stepC;
            }
        }
    }

    private static int color(ScreenVertices v, int a, int b, int c, float weightB, float weightC) {
        float qa = v.nearness(a);
        float ofB = v.nearness(b);
        float ofC = v.nearness(c);
        float w = 1 / (qa + weightB * (ofB - qa) + weightC * (ofC - qa));
        float shareB = weightB * ofB * w;
        float shareC = weightC * ofC * w;
        float[] rgb = v.values;
        int atA = v.at(a);
        int atB = v.at(b);
        int atC = v.at(c);
        float red = rgb[atA];
        float green = rgb[atA + 1];
        float blue = rgb[atA + 2];
        return SmoothFill.argb(
                red + shareB * (rgb[atB] - red) + shareC * (rgb[atC] - red),
                green + shareB * (rgb[atB + 1] - green) + shareC * (rgb[atC + 1] - green),
                blue + shareB * (rgb[atB + 2] - blue) + shareC * (rgb[atC + 2] - blue));
    }

    static void flat(Band band, TinyScan scan, ScreenVertices v, int color) {
        int[] argb = band.argb;
        float[] depth = band.depth;
        int start = band.depthStart;
        float za = v.depth(scan.a);
        float zb = v.depth(scan.b) - za;
        float zc = v.depth(scan.c) - za;
        for (int k = 0; k < scan.count; k++) {
            int cell = scan.cell[k];
            float weightB = scan.edgeB[k] * scan.inverseArea;
            float weightC = scan.edgeC[k] * scan.inverseArea;
            float here = za + weightB * zb + weightC * zc;
            if (!(here < depth[cell - start])) continue;
            depth[cell - start] = here;
            argb[cell] = color;
        }
    }
}
