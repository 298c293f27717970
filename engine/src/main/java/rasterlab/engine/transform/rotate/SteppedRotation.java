package rasterlab.engine.transform.rotate;

import rasterlab.contract.PlaneRotation;

/** A method whose turns can be looked at, one point at a time. */
public interface SteppedRotation extends PlaneRotation {
    /**
     * A walk that ends where {@code rotate} puts the point.
     *
     * @throws IllegalArgumentException as {@code rotate} does
     */
    TurnWalk walk(double degrees, int times, double x, double y);
}
