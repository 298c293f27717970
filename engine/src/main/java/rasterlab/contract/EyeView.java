package rasterlab.contract;

/**
 * Takes points from the world to the left-handed space of an eye that looks at the origin: x right,
 * y up, z forward.
 *
 * <p>The eye stands at ρ(sin φ cos θ, sin φ sin θ, cos φ).
 */
@FunctionalInterface
public interface EyeView {
    /**
     * Replaces every point by its place in eye space.
     *
     * @param theta θ in degrees, any finite angle
     * @param phi φ in degrees, any finite angle
     * @param rho ρ, above 0, up to 2¹⁰⁰⁰
     * @param points x, y, z of each point, one after the other; may be empty
     * @throws IllegalArgumentException if an argument is not finite or out of range; the message
     *     names the place
     */
    void view(double theta, double phi, double rho, double[] points);
}
