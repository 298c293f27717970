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

    /** What {@link ArcWalk#decision} is, as a formula, and what it decides. */
    String decisionFormula();

    /** What the walk computes. */
    ArcWork work();
}
