package rasterlab.engine.circle;

import rasterlab.contract.CircleRasterizer;

/** A method whose steps can be looked at: drawing and stepping drain the same walk. */
public interface SteppedCircle extends CircleRasterizer {
    /** A walk over the pixels that {@code draw} mirrors, in the same order. */
    ArcWalk walk(int radius);

    /** The formula of {@link ArcWalk#decision}, and what it decides. */
    String decisionFormula();

    /** The quantity that the walk computes. */
    ArcWork work();
}
