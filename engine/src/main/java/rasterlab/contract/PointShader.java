package rasterlab.contract;

/**
 * How bright a point of a surface is.
 *
 * <p>For red, green and blue each, with n, l, v the normal and the directions to the light and to
 * the eye, all brought to length 1:
 *
 * <pre>
 * I = emission + globalAmbient·kₐ + attenuation·cone·(Lₐ·kₐ + L_d·k_d·max(0, n·l) + L_s·k_s·max(0, c)ˢ)
 * </pre>
 *
 * cut to [0, 1] at the very end. kₐ, k_d, k_s, s are the material's ambient, diffuse, specular and
 * shininess, Lₐ, L_d, L_s the light's. c is what {@link Reflection} says; there is no specular term
 * where n·l ≤ 0, and 0⁰ is 1. The attenuation is that at the point's distance, however long the
 * vector to the light is. A share may be off by 10⁻¹².
 */
@FunctionalInterface
public interface PointShader {
    /**
     * Red, green and blue of the light that reaches the eye.
     *
     * @return three shares from 0 to 1, in a new array
     * @throws IllegalArgumentException if the normal or the vector to the light is (0, 0, 0), if
     *     the one to the eye is and there is a specular term, or if the light stands in the point
     *     and its attenuation has no constant; the message names it. Nothing else may be refused
     */
    double[] intensity(LitPoint point);

    /** The specular term this method has. */
    default Reflection reflection() {
        return Reflection.PHONG;
    }
}
