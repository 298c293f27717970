package rasterlab.contract;

/**
 * The way a surface reflects light; three shares each, of red, green and blue, from 0 to 1.
 *
 * @param ambient of the light that comes from everywhere
 * @param diffuse of the light scattered evenly
 * @param specular of the light mirrored
 * @param emission light of its own
 * @param shininess exponent of the mirrored light, 0 to 200
 */
public record SurfaceMaterial(
        double[] ambient,
        double[] diffuse,
        double[] specular,
        double[] emission,
        double shininess) {
    /** The highest exponent. */
    public static final double HIGHEST_SHININESS = 200;

    public SurfaceMaterial {
        ambient = Numbers.shares("ambient", ambient, 1);
        diffuse = Numbers.shares("diffuse", diffuse, 1);
        specular = Numbers.shares("specular", specular, 1);
        emission = Numbers.shares("emission", emission, 1);
        if (!(shininess >= 0 && shininess <= HIGHEST_SHININESS))
            throw new IllegalArgumentException("shininess must be from 0 to 200, got " + shininess);
    }
}
