package rasterlab.contract;

/** Where a method sends the part of a segment in space that is left. */
@FunctionalInterface
public interface SpaceSegmentSink {
    /** Takes the segment from (x0, y0, z0) to (x1, y1, z1); a point has two equal ends. */
    void segment(double x0, double y0, double z0, double x1, double y1, double z1);
}
