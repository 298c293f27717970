package rasterlab.engine.light;

import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;

/**
 * A light in its place, in the units and axes of the points it shines on.
 *
 * @param source what it sends out
 * @param x of its position, or of the direction to it
 * @param y of its position, or of the direction to it
 * @param z of its position, or of the direction to it
 * @param directional whether it is infinitely far: such a light has neither cone nor attenuation
 */
public record Light(LightSource source, double x, double y, double z, boolean directional) {
    public Light {
        if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z))
            throw new IllegalArgumentException(
                    "light must be finite, got (%s, %s, %s)".formatted(x, y, z));
        if (directional) requireFar(source, x, y, z);
    }

    private static void requireFar(LightSource source, double x, double y, double z) {
        if (x == 0 && y == 0 && z == 0)
            throw new IllegalArgumentException(
                    "direction to the light must be finite and not zero, got (%s, %s, %s)"
                            .formatted(x, y, z));
        if (!source.cone().shinesAllAround() || !source.attenuation().equals(Attenuation.none()))
            throw new IllegalArgumentException(
                    "a directional light has neither cone nor attenuation, got cutoff %s and %s"
                            .formatted(source.cone().cutoff(), source.attenuation()));
    }

    /** A lamp at (x, y, z). */
    public static Light at(LightSource source, double x, double y, double z) {
        return new Light(source, x, y, z, false);
    }

    /** A sun infinitely far in the direction (x, y, z). */
    public static Light from(LightSource source, double x, double y, double z) {
        return new Light(source, x, y, z, true);
    }
}
