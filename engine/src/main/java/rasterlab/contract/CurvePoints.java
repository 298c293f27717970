package rasterlab.contract;

/** Where a curve method sends its points, from the curve's start to its end. */
@FunctionalInterface
public interface CurvePoints {
    /**
     * Takes one point.
     *
     * @param x pixels, grows to the right
     * @param y pixels, grows down
     */
    void point(double x, double y);
}
