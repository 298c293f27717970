package rasterlab.engine.clip.segment;

import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;

/** A method whose steps can be looked at: clipping and stepping drain the same walk. */
public interface SteppedSegmentClipper extends SegmentClipper {
    /**
     * A walk that makes the cuts of {@code clip}, in the same order.
     *
     * @throws IllegalArgumentException as {@code clip} does, now or from {@link SegmentWalk#send}
     */
    SegmentWalk walk(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1);

    /** The formula of {@link SegmentWalk#decision}. */
    String decisionFormula();

    @Override
    default void clip(
            double xmin,
            double ymin,
            double xmax,
            double ymax,
            double x0,
            double y0,
            double x1,
            double y1,
            SegmentSink out) {
        SegmentWalk walk = walk(xmin, ymin, xmax, ymax, x0, y0, x1, y1);
        while (walk.advance()) continue;
        walk.send(out);
    }
}
