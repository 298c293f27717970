package rasterlab.engine.visibility.order;

import rasterlab.contract.DepthOrder;
import rasterlab.contract.PieceSink;

/** A method that can be watched while it orders. */
public interface SteppedOrder extends DepthOrder {
    /**
     * A walk that has painted nothing yet.
     *
     * @throws IllegalArgumentException if a polygon is narrower or nearer to the eye than the
     *     contract allows
     */
    default OrderWalk walk(Sight sight, PieceSink out) {
        SightRange.require(sight);
        return walk(sight, out, () -> {});
    }

    /**
     * A walk of which the caller may tire, for polygons out of range too: what is seen in pixels
     * may be right where the whole of it is not.
     *
     * @param pulse run now and then, before the first step too; what it throws ends the work
     */
    OrderWalk walk(Sight sight, PieceSink out, Runnable pulse);

    /** The meaning of a step's value. */
    String decision();

    @Override
    default void order(double[][] polygons, double[] eye, PieceSink out) {
        OrderWalk walk = walk(new Sight(polygons, eye), out);
        boolean more;
        do more = walk.advance();
        while (more);
    }
}
