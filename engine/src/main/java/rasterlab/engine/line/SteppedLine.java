package rasterlab.engine.line;

import rasterlab.contract.LineRasterizer;

/** A method whose steps can be looked at: drawing and stepping drain the same walk. */
public interface SteppedLine extends LineRasterizer {
    /** Which pixel a decision value is about. */
    enum Decides {
        /** The pixel that the value is shown with, and that it chose. */
        THIS_PIXEL,
        /** The pixel after the one that the value is shown with. */
        NEXT_PIXEL
    }

    /**
     * A walk over the pixels that {@code draw} sends, in the same order.
     *
     * @throws IllegalArgumentException as {@code draw} does
     */
    LineWalk walk(int x0, int y0, int x1, int y1);

    /** The formula of {@link LineWalk#decision}, and when it makes the line step aside. */
    String decisionFormula();

    /** Which pixel {@link LineWalk#decision} chooses. */
    Decides decides();

    /** The quantity that the walk computes. */
    LineWork work();
}
