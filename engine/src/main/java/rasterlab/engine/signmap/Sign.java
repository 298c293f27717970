package rasterlab.engine.signmap;

/** What is said of a point: −1, 0 or 1. */
@FunctionalInterface
interface Sign {
    int of(double x, double y);
}
