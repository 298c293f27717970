package rasterlab.engine.visibility;

/** Draws a picture step by step. */
public interface VisibilityWalk {
    /** Does the next step; false when the picture is done. */
    boolean advance();

    /** The step done last; only after {@link #advance} returned true. */
    VisibilityStep step();

    /** The work so far. */
    VisibilityWork work();
}
