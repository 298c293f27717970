package rasterlab.engine.geometry;

import rasterlab.engine.range.Finite;

/**
 * The plane n·p = c, with f(p) = n·p − c on its two sides.
 *
 * @param normal n = (A, B, C), not of length 0
 * @param c n·a for any point a of the plane
 */
public record Plane(Vector normal, double c) {
    /** Normals whose largest coordinate lies between 2 to the powers of this and its negative. */
    private static final int MOST_EXPONENT = 500;

    public Plane {
        Finite.require("c", c);
        if (normal.length() == 0)
            throw new IllegalArgumentException(
                    "normal must not be zero, got "
                            + new Vector(normal.x() + 0.0, normal.y() + 0.0, normal.z() + 0.0));
    }

    /** The plane through {@code point} with that normal. */
    public static Plane through(Vector point, Vector normal) {
        return new Plane(normal, normal.dot(point));
    }

    /**
     * The plane through three points; its normal is (p − q) × (p − r), or a power of two times that
     * where it would leave the range of doubles.
     *
     * @throws IllegalArgumentException if the three lie on one line
     */
    public static Plane through(Vector p, Vector q, Vector r) {
        return through(q, normal(p, q, r));
    }

    /**
     * The normal alone, which is within doubles where c is not.
     *
     * @throws IllegalArgumentException if the three lie on one line
     */
    public static Vector normal(Vector p, Vector q, Vector r) {
        Vector a = p.minus(q);
        Vector b = p.minus(r);
        Vector near1 = a.shifted(-a.exponent()).cross(b.shifted(-b.exponent()));
        if (near1.length() == 0)
            throw new IllegalArgumentException(
                    "three points on one line have no plane: " + p + ", " + q + ", " + r);
        int shift = a.exponent() + b.exponent();
        boolean fits = Math.abs(shift + near1.exponent()) < MOST_EXPONENT;
        return fits ? near1.shifted(shift) : near1;
    }

    /** f(p) = Ax + By + Cz − c: positive on the side the normal points to, 0 on the plane. */
    public double side(Vector p) {
        return normal.dot(p) - c;
    }

    /** |c| / |n|. */
    public double distanceFromOrigin() {
        return Math.abs(c) / normal.length();
    }

    /** The point of the plane nearest to the origin: n·c/|n|². */
    public Vector nearestToOrigin() {
        Vector unit = normal.unit();
        return unit.times(c / normal.length());
    }

    /**
     * μ = (c − n·p₁) / (n·p*), where the line meets the plane; 0 only where p₁ seems to be in it.
     *
     * @throws IllegalArgumentException if the line is parallel to the plane, n·p* being 0, or μ or
     *     what it is computed from is beyond doubles
     */
    public double meets(Line line) {
        Vector direction = line.direction();
        Vector from = line.from();
        ProductSum slope =
                ProductSum.of(
                        new double[] {normal.x(), normal.y(), normal.z()},
                        new double[] {direction.x(), direction.y(), direction.z()});
        if (slope.mantissa() == 0)
            throw new IllegalArgumentException(
                    "line must not be parallel to the plane, but n·p* is " + slope.mantissa());
        ProductSum rise =
                ProductSum.of(
                        new double[] {-normal.x(), -normal.y(), -normal.z(), c},
                        new double[] {from.x(), from.y(), from.z(), 1});
        double mu = rise.over(slope);
        if (!Double.isFinite(mu))
            throw new IllegalArgumentException(
                    "line must meet the plane at a μ within doubles, got " + mu);
        return mu;
    }

    /** The angle between the line and the plane, in degrees from 0 to 90. */
    public double angleWith(Line line) {
        Vector n = normal.unit();
        Vector along = line.direction().unit();
        return Math.toDegrees(Math.atan2(Math.abs(n.dot(along)), n.cross(along).length()));
    }
}
