package rasterlab.engine.pipeline.triangle;

/** The weights of a triangle's corners b and c along a row, and its depth. */
final class RowWeights {
    /** Depth at corner a, and what the weights of b and c add. */
    private float za;

    private float zb;
    private float zc;

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
        stepZ = toB * zb + toC * zc;
    }

    void at(TriangleScan scan, int row) {
        rowB = (float) scan.edgeB[row] * scan.inverseArea;
        rowC = (float) scan.edgeC[row] * scan.inverseArea;
        z = za + rowB * zb + rowC * zc;
    }
}
