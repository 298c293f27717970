package rasterlab.engine.visibility.depth;

import rasterlab.contract.DepthRange;

/** A format whose codes along a scan line can be followed pixel by pixel. */
public interface SteppedDepth extends DepthCoding {
    /**
     * The walk along a scan line.
     *
     * @param nearness of the first pixel
     * @param perPixel how much nearness grows from pixel to pixel
     * @param pixels at least 1
     */
    DepthWalk walk(DepthRange range, double nearness, double perPixel, int pixels);

    /** The formula of {@link DepthWalk#decision}. */
    String decisionFormula();
}
