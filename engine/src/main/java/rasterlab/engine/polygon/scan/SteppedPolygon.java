package rasterlab.engine.polygon.scan;

import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;
import rasterlab.contract.Spans;

/** A method whose steps can be looked at: filling and stepping drain the same walk. */
public interface SteppedPolygon extends PolygonFiller {
    /**
     * A walk over the spans that {@code fill} sends, in the same order.
     *
     * @throws IllegalArgumentException as {@code fill} does
     */
    SpanWalk walk(double[] x, double[] y, FillRule rule, int width, int height);

    @Override
    default void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out) {
        SpanWalk walk = walk(x, y, rule, width, height);
        while (walk.advance()) out.span(walk.y(), walk.from(), walk.to());
    }
}
