package rasterlab.contract;

/**
 * A point of a surface in the light of one source. Vectors are x, y, z of any length; what lies
 * behind the surface is not asked for.
 *
 * @param normal out of the seen side of the surface
 * @param toLight from the point to the light
 * @param toEye from the point to the eye
 * @param distance from the point to the light, 0 or more
 * @param globalAmbient light from everywhere that no source sends, shares 0 to 1000
 */
public record LitPoint(
        double[] normal,
        double[] toLight,
        double[] toEye,
        double distance,
        SurfaceMaterial material,
        LightSource light,
        double[] globalAmbient) {
    public LitPoint {
        normal = Numbers.vector("normal", normal);
        toLight = Numbers.vector("to-light", toLight);
        toEye = Numbers.vector("to-eye", toEye);
        globalAmbient = Numbers.shares("global-ambient", globalAmbient, LightSource.BRIGHTEST);
        if (!(distance >= 0 && distance < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "distance must be finite and not negative, got " + distance);
    }
}
