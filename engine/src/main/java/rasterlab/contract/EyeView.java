package rasterlab.contract;

/**
 * Takes points from the world to the left-handed space of an eye that looks at the origin: x right,
 * y up, z forward.
 *
 * <p>The eye stands at ρ(sin φ cos θ, sin φ sin θ, cos φ). For every φ, also where the eye stands
 * straight above or below, its axes are x = (−sin θ, cos θ, 0), y = (−cos φ cos θ, −cos φ sin θ,
 * sin φ) and z = −(sin φ cos θ, sin φ sin θ, cos φ): z of the world is up for φ from 0° to 180°,
 * and the picture stands on its head beyond. A point's place in eye space is what each of them
 * measures from the eye on; nothing is divided by z, and points at the eye and behind it are points
 * as any other. A coordinate may be off by 16·2⁻⁵³, or by what an exercise allows, of the largest
 * of ρ and the point's coordinates in size.
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
