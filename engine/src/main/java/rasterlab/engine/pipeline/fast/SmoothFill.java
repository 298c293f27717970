package rasterlab.engine.pipeline.fast;

/** Colours of the vertices, perspective-correct between them, with a division for each pixel. */
final class SmoothFill {
    /**
     * Leaves, when added to a level, the nearest whole number in the sum's lowest bits, 0x4B above.
     */
    static final float ROUND = 0x1p23f;

    private SmoothFill() {}

    static void perspective(Band band, TriangleScan scan, ScreenVertices v, RowWeights weights) {
        int[] argb = band.argb;
        float[] depth = band.depth;
        int start = band.depthStart;
        int a = scan.a;
        int b = scan.b;
        int c = scan.c;
        float qa = v.nearness(a);
        float qb = v.nearness(b);
        float qc = v.nearness(c);
        float ra = v.attribute(0, a) * qa;
        float rb = v.attribute(0, b) * qb - ra;
        float rc = v.attribute(0, c) * qc - ra;
        float ga = v.attribute(1, a) * qa;
        float gb = v.attribute(1, b) * qb - ga;
        float gc = v.attribute(1, c) * qc - ga;
        float ba = v.attribute(2, a) * qa;
        float bb = v.attribute(2, b) * qb - ba;
        float bc = v.attribute(2, c) * qc - ba;
        qb -= qa;
        qc -= qa;
        weights.load(scan, v);
        float toB = weights.toB;
        float toC = weights.toC;
        float stepZ = weights.depth.stepZ;
        for (int row = 0; row < scan.rows; row++) {
            weights.at(scan, row);
            float z = weights.depth.z;
            int first = weights.depth.first;
            int firstWeight = weights.first;
            float rowB = weights.rowB;
            float rowC = weights.rowC;
            int from = scan.cell(row);
            for (int k = 0; k < scan.count[row]; k++) {
                float here = z + (first + k) * stepZ;
                if (!(here < depth[from + k - start])) continue;
                depth[from + k - start] = here;
                float column = firstWeight + k;
                float weightB = rowB + column * toB;
                float weightC = rowC + column * toC;
                float w = 1 / (qa + weightB * qb + weightC * qc);
                argb[from + k] =
                        argb(
                                (ra + weightB * rb + weightC * rc) * w,
                                (ga + weightB * gb + weightC * gc) * w,
                                (ba + weightB * bb + weightC * bc) * w);
            }
        }
    }

    /** An opaque colour of three levels, 0 to 255 or beyond by less than a quarter. */
    static int argb(float red, float green, float blue) {
        return 0xFF000000
                | Float.floatToRawIntBits(red + ROUND) << 16
                | Float.floatToRawIntBits(green + ROUND) << 8
                | Float.floatToRawIntBits(blue + ROUND);
    }
}
