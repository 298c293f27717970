package rasterlab.contract;

/** Tells where the straight line p(μ) = p₁ + μ·(p₂ − p₁) meets the plane n·p = c. */
@FunctionalInterface
public interface LinePlane {
    /**
     * The μ of the common point: below 0 behind p₁, from 0 to 1 between the two points, above 1
     * beyond p₂.
     *
     * @param normal n = (A, B, C), not all 0
     * @param c n·a for any point a of the plane
     * @param from p₁ = (x, y, z)
     * @param through p₂, another point
     * @throws IllegalArgumentException if a number is not finite, the line is parallel to the plane
     *     or in it; a method may refuse, too, coordinates more than 2⁴⁰⁰ apart and a c more than
     *     2⁹⁰⁰ from those of the points; the message says which
     */
    double meets(double[] normal, double c, double[] from, double[] through);

    /**
     * The meeting where a point of the plane is known: n·(p − a) = 0.
     *
     * <p>A method that is content with c is given n·a as doubles round it. One that must not lose
     * what is rounded off there overrides this.
     *
     * @param normal as above, as are {@code from}, {@code through}, the answer and the refusals
     * @param point a = (x, y, z), any point of the plane
     */
    default double meetsThrough(double[] normal, double[] point, double[] from, double[] through) {
        double c = normal[0] * point[0] + normal[1] * point[1] + normal[2] * point[2];
        return meets(normal, c, from, through);
    }
}
