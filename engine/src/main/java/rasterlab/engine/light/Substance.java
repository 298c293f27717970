package rasterlab.engine.light;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.naming.Named;

/**
 * Materials to begin with: shares of ambient, diffuse and specular light, and shininess.
 *
 * <p>Source of all but chalk and lamp: M. J. Kilgard, teapots.c, OpenGL sample programs, 1994; his
 * shininess is a share of 128.
 */
public enum Substance {
    /** Dull and white. */
    CHALK(rgb(0.9, 0.9, 0.85), rgb(0.9, 0.9, 0.85), rgb(0, 0, 0), 0),
    RED_PLASTIC(rgb(0.3, 0, 0), rgb(0.5, 0, 0), rgb(0.7, 0.6, 0.6), 0.25),
    RED_RUBBER(rgb(0.05, 0, 0), rgb(0.5, 0.4, 0.4), rgb(0.7, 0.04, 0.04), 0.078125),
    BRASS(
            rgb(0.329412, 0.223529, 0.027451),
            rgb(0.780392, 0.568627, 0.113725),
            rgb(0.992157, 0.941176, 0.807843),
            0.21794872),
    COPPER(
            rgb(0.19125, 0.0735, 0.0225),
            rgb(0.7038, 0.27048, 0.0828),
            rgb(0.256777, 0.137622, 0.086014),
            0.1),
    GOLD(
            rgb(0.24725, 0.1995, 0.0745),
            rgb(0.75164, 0.60648, 0.22648),
            rgb(0.628281, 0.555802, 0.366065),
            0.4),
    SILVER(
            rgb(0.19225, 0.19225, 0.19225),
            rgb(0.50754, 0.50754, 0.50754),
            rgb(0.508273, 0.508273, 0.508273),
            0.4),
    JADE(rgb(0.135, 0.2225, 0.1575), rgb(0.54, 0.89, 0.63), rgb(0.316228, 0.316228, 0.316228), 0.1),
    RUBY(
            rgb(0.1745, 0.01175, 0.01175),
            rgb(0.61424, 0.04136, 0.04136),
            rgb(0.727811, 0.626959, 0.626959),
            0.6),
    TURQUOISE(
            rgb(0.1, 0.18725, 0.1745),
            rgb(0.396, 0.74151, 0.69102),
            rgb(0.297254, 0.30829, 0.306678),
            0.1);

    private static final double HIGHEST = 128;

    private final double[] ambient;
    private final double[] diffuse;
    private final double[] specular;
    private final double shininess;

    Substance(double[] ambient, double[] diffuse, double[] specular, double share) {
        this.ambient = ambient;
        this.diffuse = diffuse;
        this.specular = specular;
        shininess = share * HIGHEST;
    }

    private static double[] rgb(double red, double green, double blue) {
        return new double[] {red, green, blue};
    }

    /** Lower-case name with hyphens. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The names that {@link #named} knows. */
    public static List<String> names() {
        return Arrays.stream(values()).map(Substance::code).toList();
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static Substance named(String name) {
        return Named.find("material", name, List.of(values()), Substance::code);
    }

    /** The way it reflects light; none has light of its own. */
    public SurfaceMaterial surface() {
        return new SurfaceMaterial(ambient, diffuse, specular, new double[3], shininess);
    }
}
