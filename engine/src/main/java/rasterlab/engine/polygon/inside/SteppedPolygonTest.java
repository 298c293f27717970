package rasterlab.engine.polygon.inside;

import rasterlab.contract.PointInPolygon;

/** A method whose steps can be looked at: judging and stepping drain the same walk. */
public interface SteppedPolygonTest extends PointInPolygon {
    /**
     * A walk round the polygon for one point.
     *
     * @throws IllegalArgumentException as {@code contains} does
     */
    EdgeWalk walk(double[] polygonX, double[] polygonY, double x, double y);

    /** The formula of {@link EdgeWalk#count}, and which counts mean inside. */
    String countFormula();

    @Override
    default boolean contains(double[] polygonX, double[] polygonY, double x, double y) {
        EdgeWalk walk = walk(polygonX, polygonY, x, y);
        while (walk.advance())
            ;
        return walk.inside();
    }
}
