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
     *     or in it, or the method cannot tell; the message says which
     */
    double meets(double[] normal, double c, double[] from, double[] through);
}
