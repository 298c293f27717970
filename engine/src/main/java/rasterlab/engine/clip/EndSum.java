package rasterlab.engine.clip;

import rasterlab.contract.SegmentSink;
import rasterlab.contract.SpaceSegmentSink;

/** Adds up the ends, so that a compiler cannot leave them uncomputed. */
public final class EndSum implements SegmentSink, SpaceSegmentSink {
    private double sum;

    @Override
    public void segment(double x0, double y0, double x1, double y1) {
        sum += x0 + y0 + x1 + y1;
    }

    @Override
    public void segment(double x0, double y0, double z0, double x1, double y1, double z1) {
        sum += x0 + y0 + z0 + x1 + y1 + z1;
    }

    public void requireComputed() {
        // Never true for a workload, but the compiler cannot know: it must compute the ends.
        if (sum == Double.POSITIVE_INFINITY) throw new AssertionError("sum of ends overflowed");
    }
}
