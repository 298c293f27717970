package rasterlab.engine.pipeline.fast;

/**
 * The weights of a triangle's corners b and c in its box, {@code corner + row · down + column ·
 * right} with rows and columns counted from the box's first pixel. One per thread.
 */
final class BoxWeights {
    float cornerB;
    float cornerC;
    float downB;
    float downC;
    float rightB;
    float rightC;

    void load(TriangleScan scan) {
        cornerB = scan.cornerB() * scan.inverseArea;
        cornerC = scan.cornerC() * scan.inverseArea;
        downB = scan.downB * scan.inverseArea;
        downC = scan.downC * scan.inverseArea;
        rightB = scan.stepB * scan.inverseArea;
        rightC = scan.stepC * scan.inverseArea;
    }
}
