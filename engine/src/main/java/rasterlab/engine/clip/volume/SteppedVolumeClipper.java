package rasterlab.engine.clip.volume;

import rasterlab.contract.SpaceSegmentSink;
import rasterlab.contract.VolumeClipper;

/** A method whose steps can be looked at: clipping and stepping drain the same walk. */
public interface SteppedVolumeClipper extends VolumeClipper {
    /**
     * A walk that makes the cuts of {@code clip}, in the same order.
     *
     * @throws IllegalArgumentException as {@code clip} does, now or from {@link VolumeWalk#send}
     */
    VolumeWalk walk(double zmin, double x0, double y0, double z0, double x1, double y1, double z1);

    /** The formula of {@link VolumeWalk#decision}. */
    String decisionFormula();

    @Override
    default void clip(
            double zmin,
            double x0,
            double y0,
            double z0,
            double x1,
            double y1,
            double z1,
            SpaceSegmentSink out) {
        VolumeWalk walk = walk(zmin, x0, y0, z0, x1, y1, z1);
        while (walk.advance()) continue;
        walk.send(out);
    }
}
