package rasterlab.engine.polygon.scan;

import java.util.List;
import java.util.Map;

/**
 * A filling on its way down the picture, one span per step.
 *
 * <p>A new walk stands before its first span; before the first {@link #advance} and after it
 * returned false, the span means nothing.
 */
public interface SpanWalk {
    /** Moves to the next span; false when there is none, and then again each time. */
    boolean advance();

    /** Row of the span. */
    int y();

    /** First column. */
    int from();

    /** The column after the last one. */
    int to();

    /** How many edges cross the row. */
    int crossings();

    /** The edges that cross the row, from left to right; empty where the method lists none. */
    default List<RowCrossing> row() {
        return List.of();
    }

    /** The operations so far: name in the plural to number. */
    Map<String, Long> operations();
}
