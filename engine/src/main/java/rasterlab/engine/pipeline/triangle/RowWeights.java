package rasterlab.engine.pipeline.triangle;

/** The weights of a triangle's corners b and c along a row, and its depth. */
final class RowWeights {
    final RowDepth depth = new RowDepth();

    /** What the weights grow by from a pixel to the next on its right. */
    float toB;

    float toC;

    /** What rows begin with where the triangle is compact. */
    final BoxWeights box = new BoxWeights();

    /** Where {@link RowDepth#first} counts the row's pixels from. */
    float rowB;

    float rowC;

    /** The row that is looked at, and how many of its pixels have been. */
    int row;

    int done;

    void load(TriangleScan scan, ScreenVertices v) {
        row = 0;
        done = 0;
        depth.load(scan, v);
        box.load(scan);
        toB = box.rightB;
        toC = box.rightC;
    }

    void at(TriangleScan scan, int row) {
        depth.at(scan, row);
        if (depth.compact) {
            rowB = row * box.downB + box.cornerB;
            rowC = row * box.downC + box.cornerC;
        } else {
            rowB = (float) (scan.edgeB[row] * scan.inverseArea);
            rowC = (float) (scan.edgeC[row] * scan.inverseArea);
        }
    }
}
