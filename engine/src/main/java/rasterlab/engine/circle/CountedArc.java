package rasterlab.engine.circle;

import java.util.Map;
import java.util.TreeMap;

/** A walk that counts what it does on its way, to be multiplied with the work of each. */
abstract class CountedArc implements ArcWalk {
    long choices;
    long asides;
    long downs;

    @Override
    public final Map<String, Long> operations(ArcWork work) {
        var counts = new TreeMap<String, Long>();
        work.choice().addTo(counts, choices);
        work.aside().addTo(counts, asides);
        work.down().addTo(counts, downs);
        counts.put("sines and roots", choices * work.functions());
        return counts;
    }
}
