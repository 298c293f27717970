package rasterlab.engine.geometry;

/**
 * The plane n·p = c, with f(p) = n·p − c on its two sides.
 *
 * @param normal n = (A, B, C), not of length 0
 * @param c n·a for any point a of the plane
 */
public record Plane(Vector normal, double c) {
    public Plane {
        Finite.require("c", c);
        if (normal.length() == 0)
            throw new IllegalArgumentException("a plane's normal must not be " + normal);
    }

    /** The plane through {@code point} with that normal. */
    public static Plane through(Vector point, Vector normal) {
        return new Plane(normal, normal.dot(point));
    }

    /**
     * The plane through three points; its normal is (p − q) × (p − r).
     *
     * @throws IllegalArgumentException if the three lie on one line
     */
    public static Plane through(Vector p, Vector q, Vector r) {
        Vector normal = p.minus(q).cross(p.minus(r));
        if (normal.length() == 0)
            throw new IllegalArgumentException(
                    "three points on one line have no plane: " + p + ", " + q + ", " + r);
        return through(q, normal);
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
     * μ = (c − n·p₁) / (n·p*), where the line meets the plane.
     *
     * @throws IllegalArgumentException if the line is parallel to the plane: n·p* is 0, or μ is no
     *     finite number
     */
    public double meets(Line line) {
        double slope = normal.dot(line.direction());
        double mu = (c - normal.dot(line.from())) / slope;
        if (slope == 0 || !Double.isFinite(mu))
            throw new IllegalArgumentException(
                    "line must not be parallel to the plane, but n·p* is " + slope);
        return mu;
    }
}
