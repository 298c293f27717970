package rasterlab.engine.pipeline.fast;

/** The weights of a triangle's corners b and c along a row, and its depth. */
final class RowWeights {
    final RowDepth depth = new RowDepth();

    /** The growth of the weights from a pixel to the next on its right. */
    float toB;

    float toC;

    /**
     * The depths that rows begin with where the triangle is {@linkplain RowDepth#gentle gentle}.
     */
    final BoxWeights box = new BoxWeights();

    /** The weights where they are counted from, and the place of the row's first pixel. */
    float rowB;

    float rowC;
    int first;

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
        if (depth.gentle) {
            first = depth.first;
            rowB = row * box.downB + box.cornerB;
            rowC = row * box.downC + box.cornerC;
        } else {
            first = 0;
            rowB = (float) (scan.edgeB[row] * scan.inverseArea);
            rowC = (float) (scan.edgeC[row] * scan.inverseArea);
        }
    }
}
