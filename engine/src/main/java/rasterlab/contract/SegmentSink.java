package rasterlab.contract;

/** Where a method sends the part of a plane segment that is left. */
@FunctionalInterface
public interface SegmentSink {
    /** Takes the segment from (x0, y0) to (x1, y1); a single point has two equal ends. */
    void segment(double x0, double y0, double x1, double y1);
}
