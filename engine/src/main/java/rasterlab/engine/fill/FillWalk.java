package rasterlab.engine.fill;

/**
 * A fill on its way through a region, one run of pixels per step.
 *
 * <p>A new walk stands before its first run; before the first {@link #advance} and after it
 * returned false, the run means nothing.
 */
public interface FillWalk {
    /** Fills the next run; false when the region is filled, and then again each time. */
    boolean advance();

    /** Row of the run just filled. */
    int y();

    /** The first column of the run. */
    int from();

    /** The column after its last one. */
    int to();

    /** How many places wait on the stack to be looked at. */
    int waiting();
}
