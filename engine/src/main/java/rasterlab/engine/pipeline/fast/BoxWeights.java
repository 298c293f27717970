package rasterlab.engine.pipeline.fast;

/**
 * The weights of a triangle's corners b and c in its box, {@code (corner + row · down + column ·
 * right) · scale} with rows and columns counted from the box's first pixel. One per thread.
 */
final class BoxWeights {
    float cornerB;
    float cornerC;
    float downB;
    float downC;
    float rightB;
    float rightC;
    float scale;

    void load(TriangleScan scan) {
        cornerB = scan.cornerB() * scan.inverseArea;
        cornerC = scan.cornerC() * scan.inverseArea;
        downB = scan.downB * scan.inverseArea;
        downC = scan.downC * scan.inverseArea;
        rightB = scan.stepB * scan.inverseArea;
        rightC = scan.stepC * scan.inverseArea;
        scale = 1;
    }

    /** Edge functions of a small triangle are whole numbers that a float holds: all are exact. */
    void load(TinyScan scan) {
        cornerB = scan.rowB;
        cornerC = scan.rowC;
        downB = scan.downB;
        downC = scan.downC;
        rightB = scan.stepB;
        rightC = scan.stepC;
        scale = scan.inverseArea;
    }
}
