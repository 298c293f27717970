package rasterlab.engine.light;

import rasterlab.contract.Reflection;

/**
 * The cosine that the specular term raises to a power, from directions of length 1: n the normal, l
 * to the light, v to the eye.
 *
 * <p>Sources: B. T. Phong, Illumination for computer generated pictures, Communications of the ACM
 * 18(6), 1975, pp. 311–317 (r·v); J. F. Blinn, Models of light reflection for computer synthesized
 * pictures, SIGGRAPH 1977, pp. 192–198 (n·h).
 */
public final class SpecularCosine {
    /** The length of l + v below which the eye is taken to look straight at the light's back. */
    private static final double OPPOSITE = 0x1p-40;

    private SpecularCosine() {}

    /**
     * r·v with r = 2·(n·l)·n − l, or n·h with h = (l + v)/|l + v|; 0 where it is negative, where l
     * and v are opposite, and for a dull surface.
     */
    public static double cosine(
            Reflection reflection,
            double nx,
            double ny,
            double nz,
            double lx,
            double ly,
            double lz,
            double vx,
            double vy,
            double vz) {
        if (reflection == Reflection.LAMBERT) return 0;
        if (reflection == Reflection.PHONG) {
            double nl = nx * lx + ny * ly + nz * lz;
            double nv = nx * vx + ny * vy + nz * vz;
            double lv = lx * vx + ly * vy + lz * vz;
            return Math.max(0, 2 * nl * nv - lv);
        }
        double hx = lx + vx;
        double hy = ly + vy;
        double hz = lz + vz;
        double length = Math.sqrt(hx * hx + hy * hy + hz * hz);
        if (length < OPPOSITE) return 0;
        return Math.max(0, (nx * hx + ny * hy + nz * hz) / length);
    }
}
