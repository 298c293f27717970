package rasterlab.engine.circle;

import rasterlab.contract.CircleRasterizer;

/** A method whose steps can be looked at: drawing and stepping drain the same walk. */
public interface SteppedCircle extends CircleRasterizer {
    /** A walk over the pixels that {@code draw} mirrors, in the same order. */
    ArcWalk walk(int radius);

    /** What {@link ArcWalk#decision} is, as a formula, and what it decides. */
    String decisionFormula();

    /** What the walk computes. */
    ArcWork work();
}
