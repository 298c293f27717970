package rasterlab.engine.geometry;

/** A point of space, or the arrow to it from the origin. Coordinates are finite. */
public record Vector(double x, double y, double z) {
    public Vector {
        Finite.require("coordinate", x, y, z);
    }

    public Vector plus(Vector other) {
        return new Vector(x + other.x, y + other.y, z + other.z);
    }

    public Vector minus(Vector other) {
        return new Vector(x - other.x, y - other.y, z - other.z);
    }

    public Vector times(double factor) {
        return new Vector(factor * x, factor * y, factor * z);
    }

    /** |p|·|q|·cos of the angle between them. */
    public double dot(Vector other) {
        return x * other.x + y * other.y + z * other.z;
    }

    /** Perpendicular to both, of length |p|·|q|·sin of the angle; i × j = k. */
    public Vector cross(Vector other) {
        return new Vector(
                y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
    }

    /** |p|, also where a square would leave the range of doubles. */
    public double length() {
        return Math.hypot(Math.hypot(x, y), z);
    }

    /**
     * Length of the shadow on {@code direction}, negative where the angle is obtuse: a·b/|b|.
     *
     * @throws IllegalArgumentException if {@code direction} has no length
     */
    public double projectedOn(Vector direction) {
        return dot(direction.unit());
    }

    /**
     * The vector of length 1 in this direction; its coordinates are the direction cosines, the
     * cosines of the angles to the three axes, whose squares add up to 1.
     *
     * @throws IllegalArgumentException if this is (0, 0, 0)
     */
    public Vector unit() {
        // A power of two brings the largest coordinate near 1 without rounding any that counts.
        double largest = Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
        if (largest == 0)
            throw new IllegalArgumentException("direction (0, 0, 0) has no length; give another");
        int exponent = Math.getExponent(largest);
        double px = Math.scalb(x, -exponent);
        double py = Math.scalb(y, -exponent);
        double pz = Math.scalb(z, -exponent);
        double length = Math.sqrt(px * px + py * py + pz * pz);
        return new Vector(px / length, py / length, pz / length);
    }
}
