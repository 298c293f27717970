package rasterlab.engine.visibility;

/** Draws a picture step by step. */
public interface VisibilityWalk {
    /** Does the next step; false when the picture is done. */
    boolean advance();

    /** What was done last; only after {@link #advance} said true. */
    VisibilityStep step();

    /** What was done so far. */
    VisibilityWork work();
}
