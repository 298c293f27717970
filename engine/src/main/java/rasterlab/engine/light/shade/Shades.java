package rasterlab.engine.light.shade;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;
import rasterlab.contract.Reflection;

/**
 * Intensities of the same points.
 *
 * @param rgb by specular term: of a method its own, of the reference all; three shares of each
 *     point, one after the other, NaN where there is no answer
 */
public record Shades(Map<Reflection, double[]> rgb) {
    public Shades {
        rgb = Collections.unmodifiableMap(new EnumMap<>(rgb));
    }
}
