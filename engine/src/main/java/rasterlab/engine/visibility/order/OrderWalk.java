package rasterlab.engine.visibility.order;

import java.util.Map;

/** Orders polygons step by step; what is painted goes to the sink it was made with. */
public interface OrderWalk {
    /** Paints, moves or cuts one polygon; false when all are painted. */
    boolean advance();

    /** What was done last. */
    OrderStep step();

    /** What was done so far: name in the plural to number. */
    Map<String, Long> operations();
}
