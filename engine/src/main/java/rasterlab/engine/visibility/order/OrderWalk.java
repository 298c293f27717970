package rasterlab.engine.visibility.order;

import java.util.List;
import java.util.Map;

/** Orders polygons step by step; what is painted goes to the sink it was made with. */
public interface OrderWalk {
    /** Paints, moves or cuts one polygon; false when all are painted. */
    boolean advance();

    /** The step done last. */
    OrderStep step();

    /** The cuts that made the piece that was given last to the sink; none for a whole polygon. */
    default List<Cut> cuts() {
        return List.of();
    }

    /** The operations so far: name in the plural to number. */
    Map<String, Long> operations();
}
