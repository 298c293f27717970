package rasterlab.engine.visibility.order;

import rasterlab.contract.DepthOrder;
import rasterlab.contract.PieceSink;

/** A method that can be watched while it orders. */
public interface SteppedOrder extends DepthOrder {
    /** A walk that has painted nothing yet. */
    OrderWalk walk(Sight sight, PieceSink out);

    /** What a step's value is. */
    String decision();

    @Override
    default void order(double[][] polygons, double[] eye, PieceSink out) {
        OrderWalk walk = walk(new Sight(polygons, eye), out);
        boolean more;
        do more = walk.advance();
        while (more);
    }
}
