package rasterlab.engine.circle;

import java.util.Map;

/**
 * A curve on its way through one octant or quadrant, one pixel per step, counted from the centre.
 *
 * <p>A new walk stands before its first pixel; before the first {@link #advance} and after it
 * returned false, the position means nothing.
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

    /** The operations so far, by name, for a method of that work. */
    Map<String, Long> operations(ArcWork work);
}
