package rasterlab.app.opengl.state;

/**
 * The material of a side, in shares of red, green and blue.
 *
 * <p>Source of brass, emerald and plastic: M. J. Kilgard, the program teapots.c, 1994, after M.
 * Woo, J. Neider, T. Davis, OpenGL Programming Guide.
 */
public record GlMaterial(double[] ambient, double[] diffuse, double[] specular, double[] emission) {
    private static final double[] DARK = new double[3];

    /**
     * @param name an option of {@link Setting#FRONT_MATERIAL}
     */
    static GlMaterial named(String name) {
        return switch (name) {
            case "brass" ->
                    new GlMaterial(
                            rgb(0.329412, 0.223529, 0.027451),
                            rgb(0.780392, 0.568627, 0.113725),
                            rgb(0.992157, 0.941176, 0.807843),
                            DARK);
            case "emerald" ->
                    new GlMaterial(
                            rgb(0.0215, 0.1745, 0.0215),
                            rgb(0.07568, 0.61424, 0.07568),
                            rgb(0.633, 0.727811, 0.633),
                            DARK);
            case "plastic" -> new GlMaterial(DARK, rgb(0.5, 0, 0), rgb(0.7, 0.6, 0.6), DARK);
            case "chalk" ->
                    new GlMaterial(
                            rgb(0.9, 0.9, 0.9), rgb(0.85, 0.85, 0.85), rgb(0.2, 0.2, 0.2), DARK);
            case "glowing" ->
                    new GlMaterial(
                            rgb(0.1, 0.1, 0.1), rgb(0.3, 0.3, 0.4), DARK, rgb(0.35, 0.2, 0.05));
            default -> throw new IllegalArgumentException("no material called '" + name + "'");
        };
    }

    private static double[] rgb(double red, double green, double blue) {
        return new double[] {red, green, blue};
    }
}
