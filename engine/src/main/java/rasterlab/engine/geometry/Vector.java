package rasterlab.engine.geometry;

import rasterlab.engine.range.Finite;

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
        if (x == 0 && y == 0 && z == 0)
            throw new IllegalArgumentException("direction must not be zero, got (0, 0, 0)");
        Vector p = shifted(-exponent());
        double length = Math.sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
        return new Vector(p.x / length, p.y / length, p.z / length);
    }

    /** The e with the largest coordinate in [2ᵉ, 2ᵉ⁺¹), below 2ᵉ⁺¹ where it is not normal. */
    int exponent() {
        return Math.getExponent(Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z))));
    }

    /**
     * This times 2 to the power of {@code by}; by −{@link #exponent} the largest coordinate comes
     * near 1 and none that counts is rounded.
     */
    Vector shifted(int by) {
        return new Vector(Math.scalb(x, by), Math.scalb(y, by), Math.scalb(z, by));
    }

    @Override
    public String toString() {
        return "(" + x + ", " + y + ", " + z + ")";
    }
}
