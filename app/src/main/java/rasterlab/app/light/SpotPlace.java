package rasterlab.app.light;

import java.util.Optional;
import rasterlab.contract.LitPoint;

/**
 * Where a point and the spot that shines past it stand in the lab, whose spots look at the middle:
 * the spot's axis meets the point's plane there.
 *
 * <p>The point has the z axis for its normal and the axis lies in y = 0.
 *
 * @param x of the point
 * @param lampX of the lamp
 * @param lampZ of the lamp
 */
record SpotPlace(double x, double lampX, double lampZ) {
    /** The place in the spot; empty where the point's light has no cone. */
    static Optional<SpotPlace> of(LitPoint point) {
        if (point.light().cone().shinesAllAround()) return Optional.empty();
        double[] axis = point.light().cone().direction();
        double lampX = point.toLight()[0] * point.distance();
        double lampZ = point.toLight()[2] * point.distance();
        double meets = lampX - lampZ * axis[0] / axis[2];
        return Optional.of(new SpotPlace(-meets, lampX - meets, lampZ));
    }
}
