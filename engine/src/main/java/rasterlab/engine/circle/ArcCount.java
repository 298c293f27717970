package rasterlab.engine.circle;

import java.util.Map;
import java.util.TreeMap;

/**
 * The choices of a walk and its steps, to be multiplied with the work of each.
 *
 * @param choices of the next pixel, among them one that ended the walk
 * @param asides steps to the next column
 * @param downs steps to the row below
 */
record ArcCount(long choices, long asides, long downs) {
    /**
     * Drains a walk and counts by its positions: each move from a pixel is a choice. A walk that
     * chooses more often than it moves counts for itself.
     */
    static ArcCount of(ArcWalk walk) {
        if (walk instanceof CountedArc counted) return counted.drain();
        int u = walk.u();
        int v = walk.v();
        long moves = 0;
        long asides = 0;
        long downs = 0;
        boolean first = true;
        boolean more;
        do {
            more = walk.advance();
            boolean moved = walk.u() != u || walk.v() != v;
            if (moved && !first) moves++;
            if (more) asides += walk.u() - u;
            downs += v - walk.v();
            u = walk.u();
            v = walk.v();
            first = false;
        } while (more);
        return new ArcCount(moves, asides, downs);
    }

    /** The operations by name, for a method of that work. */
    Map<String, Long> operations(ArcWork work) {
        var counts = new TreeMap<String, Long>();
        work.choice().addTo(counts, choices);
        work.aside().addTo(counts, asides);
        work.down().addTo(counts, downs);
        counts.put("sines and roots", choices * work.functions());
        return counts;
    }
}
