package rasterlab.contract;

/** Where a method sends the polygons that are left. */
@FunctionalInterface
public interface PolygonSink {
    /**
     * Takes one polygon.
     *
     * @param corners x and y of each corner in turn, counter-clockwise where y grows up; the last
     *     is joined to the first. The receiver may keep the array.
     */
    void polygon(double[] corners);
}
