package rasterlab.engine.circle;

/**
 * A curve on its way through one octant or quadrant, one pixel per step, counted from the centre.
 *
 * <p>A new walk stands before its first pixel or on it; before the first {@link #advance} and after
 * it returned false, the position is no pixel of the curve.
 */
public interface ArcWalk {
    /** Moves to the next pixel; false when there is none, and then again each time. */
    boolean advance();

    /** Columns from the centre. */
    int u();

    /** Rows from the centre. */
    int v();

    /** The number by which the method chooses the next pixel. */
    double decision();
}
