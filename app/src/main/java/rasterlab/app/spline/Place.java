package rasterlab.app.spline;

/**
 * A control point in pixels, or a knot with its value.
 *
 * @param x of a knot: where it is
 * @param y of a knot: its value
 */
public record Place(double x, double y) {
    Place plus(double dx, double dy) {
        return new Place(tidy(x + dx), tidy(y + dy));
    }

    /** The end of the vector to {@code other}, made {@code factor} times as long. */
    Place towards(Place other, double factor) {
        return plus(factor * (other.x - x), factor * (other.y - y));
    }

    double distance(Place other) {
        return Math.hypot(other.x - x, other.y - y);
    }

    /** The number without the digits that rounding leaves behind sums of short decimals. */
    static double tidy(double value) {
        double millionths = Math.rint(value * 1e6) / 1e6;
        return Math.abs(millionths - value) < 1e-9 ? millionths + 0.0 : value;
    }
}
