package rasterlab.engine.signmap;

/** The answer for a point: −1, 0 or 1. */
@FunctionalInterface
interface Sign {
    int of(double x, double y);
}
