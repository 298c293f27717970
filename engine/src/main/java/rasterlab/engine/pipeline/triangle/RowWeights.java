package rasterlab.engine.pipeline.triangle;

/** The weights of a triangle's corners b and c along a row, and its depth. */
final class RowWeights {
    /** Depth at corner a, and what the weights of b and c add. */
    private double za;

    private double zb;
    private double zc;

    /** What the weights and the depth grow by from a pixel to the next on its right. */
    float toB;

    float toC;
    float stepZ;

    /** At the first pixel of the row. */
    float rowB;

    float rowC;
    float z;

    void load(TriangleScan scan, ScreenVertices v) {
        za = v.depth[scan.a];
        zb = v.depth[scan.b] - za;
        zc = v.depth[scan.c] - za;
        toB = scan.stepB * scan.inverseArea;
        toC = scan.stepC * scan.inverseArea;
        stepZ = (float) (toB * zb + toC * zc);
    }

    void at(TriangleScan scan, int row) {
        double weightB = scan.edgeB[row] * scan.inverseArea;
        double weightC = scan.edgeC[row] * scan.inverseArea;
        rowB = (float) weightB;
        rowC = (float) weightC;
        z = (float) (weightB * zb + za + weightC * zc);
    }
}
