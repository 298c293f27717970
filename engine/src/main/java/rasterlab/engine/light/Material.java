package rasterlab.engine.light;

import rasterlab.contract.SurfaceMaterial;

/**
 * The material of a surface.
 *
 * @param surface what it does with light
 * @param alpha how much it hides of what lies behind, 0 (nothing) to 1 (all)
 */
public record Material(SurfaceMaterial surface, double alpha) {
    public Material {
        if (!(alpha >= 0 && alpha <= 1))
            throw new IllegalArgumentException("alpha must be from 0 to 1, got " + alpha);
    }

    /** A dull opaque surface that sends back so much ambient and diffuse light. */
    public static Material dull(double red, double green, double blue) {
        double[] color = {red, green, blue};
        return new Material(new SurfaceMaterial(color, color, new double[3], new double[3], 0), 1);
    }

    /** This material with white highlights. */
    public Material shiny(double specular, double shininess) {
        double[] white = {specular, specular, specular};
        return new Material(
                new SurfaceMaterial(
                        surface.ambient(), surface.diffuse(), white, surface.emission(), shininess),
                alpha);
    }
}
