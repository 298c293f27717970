package rasterlab.engine.pipeline.triangle;

/** The weights of a triangle's corners b and c along a row, and its depth. */
final class RowWeights {
    final RowDepth depth = new RowDepth();

    /** What the weights grow by from a pixel to the next on its right. */
    float toB;

    float toC;

    /** At the first pixel of the row. */
    float rowB;

    float rowC;

    /** The row that is looked at, and how many of its pixels have been. */
    int row;

    int done;

    void load(TriangleScan scan, ScreenVertices v) {
        row = 0;
        done = 0;
        depth.load(scan, v);
        toB = scan.stepB * scan.inverseArea;
        toC = scan.stepC * scan.inverseArea;
    }

    void at(TriangleScan scan, int row) {
        depth.at(scan, row);
        rowB = (float) (scan.edgeB[row] * scan.inverseArea);
        rowC = (float) (scan.edgeC[row] * scan.inverseArea);
    }
}
