package rasterlab.engine.visibility.depth;

/** A window depth that goes along a scan line by additions. It stands on the first pixel. */
public interface DepthWalk {
    /**
     * Goes to the next pixel.
     *
     * @return false if this was the last one
     */
    boolean advance();

    /** Pixels since the first one. */
    int pixel();

    /** The sum so far, in the format's numbers. */
    double sum();

    /** The code that is stored. */
    int code();

    /** How far the sum has drifted, as {@link SteppedDepth#decisionFormula} says. */
    double decision();
}
