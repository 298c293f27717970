package rasterlab.engine.circle;

import rasterlab.contract.EllipseRasterizer;

/** A method whose steps can be looked at: drawing and stepping drain the same walk. */
public interface SteppedEllipse extends EllipseRasterizer {
    /**
     * A walk over the pixels that {@code draw} mirrors, in the same order.
     *
     * @throws IllegalArgumentException as {@code draw} does
     */
    ArcWalk walk(int radiusX, int radiusY);

    /** The formula of {@link ArcWalk#decision}, and what it decides. */
    String decisionFormula();

    /** The quantity that the walk computes. */
    ArcWork work();
}
