package rasterlab.engine.clip.polygon;

import rasterlab.contract.PolygonClipper;
import rasterlab.contract.PolygonSink;

/** A method whose steps can be looked at: clipping and stepping drain the same walk. */
public interface SteppedPolygonClipper extends PolygonClipper {
    /**
     * A walk that makes the steps of {@code clip}, in the same order.
     *
     * @throws IllegalArgumentException as {@code clip} does
     */
    PolygonWalk walk(double[] window, double[] subject);

    @Override
    default void clip(double[] window, double[] subject, PolygonSink out) {
        PolygonWalk walk = walk(window, subject);
        while (walk.advance()) continue;
        walk.send(out);
    }
}
