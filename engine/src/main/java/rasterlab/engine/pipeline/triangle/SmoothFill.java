package rasterlab.engine.pipeline.triangle;

/**
 * Colours of the vertices with perspective-correct values between them.
 *
 * <p>On the picture 1/w and colour/w are linear, so a pixel's colour is their quotient. Where w
 * hardly changes over a triangle the colour itself is as good as linear, and no pixel needs a
 * division: with weights b and q = 1/w, {@code Σbqc/Σbq − Σbc} is the covariance of q and c divided
 * by Σbq, at most {@code (max c − min c)·(max q − min q) / (4·min q)}. That loop is taken where
 * this is at most {@link #TOLERANCE} levels.
 *
 * <p>Source of the bound: G. Grüss, Mathematische Zeitschrift 39, 1935.
 */
final class SmoothFill {
    /** Levels. */
    static final float TOLERANCE = 0.25f;

    /** Colours are whole numbers of 1/65536 level; this rounds to the nearest level. */
    private static final float ONE = 65536;

    private static final int HALF = 32768;

    private SmoothFill() {}

    static void fill(DepthRaster out, TriangleScan scan, ScreenVertices v) {
        if (linear(scan, v)) fillLinear(out, scan, v);
        else fillPerspective(out, scan, v);
    }

    private static boolean linear(TriangleScan scan, ScreenVertices v) {
        float qa = v.nearness[scan.a];
        float qb = v.nearness[scan.b];
        float qc = v.nearness[scan.c];
        float least = Math.min(qa, Math.min(qb, qc));
        float spread = (Math.max(qa, Math.max(qb, qc)) - least) / (4 * least);
        if (255 * spread <= TOLERANCE) return true;
        float range =
                Math.max(
                        range(v.attributes[0], scan),
                        Math.max(range(v.attributes[1], scan), range(v.attributes[2], scan)));
        return range * spread <= TOLERANCE;
    }

    private static float range(float[] channel, TriangleScan scan) {
        float a = channel[scan.a];
        float b = channel[scan.b];
        float c = channel[scan.c];
        return Math.max(a, Math.max(b, c)) - Math.min(a, Math.min(b, c));
    }

    private static void fillLinear(DepthRaster out, TriangleScan scan, ScreenVertices v) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        int width = out.width();
        int a = scan.a;
        int b = scan.b;
        int c = scan.c;
        float toB = scan.stepB * scan.inverseArea;
        float toC = scan.stepC * scan.inverseArea;
        float za = v.depth[a];
        float zb = v.depth[b] - za;
        float zc = v.depth[c] - za;
        float ra = v.attributes[0][a] * ONE + HALF;
        float rb = (v.attributes[0][b] - v.attributes[0][a]) * ONE;
        float rc = (v.attributes[0][c] - v.attributes[0][a]) * ONE;
        float ga = v.attributes[1][a] * ONE + HALF;
        float gb = (v.attributes[1][b] - v.attributes[1][a]) * ONE;
        float gc = (v.attributes[1][c] - v.attributes[1][a]) * ONE;
        float ba = v.attributes[2][a] * ONE + HALF;
        float bb = (v.attributes[2][b] - v.attributes[2][a]) * ONE;
        float bc = (v.attributes[2][c] - v.attributes[2][a]) * ONE;
        float stepZ = toB * zb + toC * zc;
        int stepRed = (int) (toB * rb + toC * rc);
        int stepGreen = (int) (toB * gb + toC * gc);
        int stepBlue = (int) (toB * bb + toC * bc);
        for (int row = 0; row < scan.rows; row++) {
            int n = scan.count[row];
            if (n == 0) continue;
            float weightB = scan.edgeB[row] * scan.inverseArea;
            float weightC = scan.edgeC[row] * scan.inverseArea;
            float z = za + weightB * zb + weightC * zc;
            int red = (int) (ra + weightB * rb + weightC * rc);
            int green = (int) (ga + weightB * gb + weightC * gc);
            int blue = (int) (ba + weightB * bb + weightC * bc);
            int from = (scan.top + row) * width + scan.left[row];
            float k = 0;
            for (int i = from; i < from + n; i++) {
                float here = z + k * stepZ;
                if (here < depth[i]) {
                    depth[i] = here;
                    argb[i] = argb(red, green, blue);
                }
                k += 1;
                red += stepRed;
                green += stepGreen;
                blue += stepBlue;
            }
        }
    }

    private static int argb(int red, int green, int blue) {
        return 0xFF000000 | red & 0xFF0000 | green >>> 8 & 0xFF00 | blue >>> 16;
    }

    private static void fillPerspective(DepthRaster out, TriangleScan scan, ScreenVertices v) {
        int[] argb = out.raster().argb();
        float[] depth = out.depth();
        int width = out.width();
        int a = scan.a;
        int b = scan.b;
        int c = scan.c;
        float toB = scan.stepB * scan.inverseArea;
        float toC = scan.stepC * scan.inverseArea;
        float za = v.depth[a];
        float zb = v.depth[b] - za;
        float zc = v.depth[c] - za;
        float qa = v.nearness[a];
        float qb = v.nearness[b];
        float qc = v.nearness[c];
        float ra = v.attributes[0][a] * qa;
        float rb = v.attributes[0][b] * qb - ra;
        float rc = v.attributes[0][c] * qc - ra;
        float ga = v.attributes[1][a] * qa;
        float gb = v.attributes[1][b] * qb - ga;
        float gc = v.attributes[1][c] * qc - ga;
        float ba = v.attributes[2][a] * qa;
        float bb = v.attributes[2][b] * qb - ba;
        float bc = v.attributes[2][c] * qc - ba;
        qb -= qa;
        qc -= qa;
        float stepZ = toB * zb + toC * zc;
        for (int row = 0; row < scan.rows; row++) {
            float rowB = scan.edgeB[row] * scan.inverseArea;
            float rowC = scan.edgeC[row] * scan.inverseArea;
            float z = za + rowB * zb + rowC * zc;
            int from = (scan.top + row) * width + scan.left[row];
            for (int k = 0; k < scan.count[row]; k++) {
                float here = z + k * stepZ;
                if (!(here < depth[from + k])) continue;
                depth[from + k] = here;
                float weightB = rowB + k * toB;
                float weightC = rowC + k * toC;
                float w = 1 / (qa + weightB * qb + weightC * qc);
                int red = (int) ((ra + weightB * rb + weightC * rc) * w + 0.5f);
                int green = (int) ((ga + weightB * gb + weightC * gc) * w + 0.5f);
                int blue = (int) ((ba + weightB * bb + weightC * bc) * w + 0.5f);
                argb[from + k] = 0xFF000000 | red << 16 | green << 8 | blue;
            }
        }
    }
}
