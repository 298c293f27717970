package rasterlab.engine.light.face;

import java.util.Locale;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Powers;
import rasterlab.engine.light.UnitVector;

/** The formula with another direction, length or distance, without refusals. */
enum SlippedLight {
    /** The mirrored direction is its opposite. */
    MIRRORED_THE_WRONG_WAY,
    /** The direction to the lamp keeps its length. */
    TO_LIGHT_NOT_NORMALIZED,
    /** The direction to the eye keeps its length. */
    TO_EYE_NOT_NORMALIZED,
    /** The lamp's place is taken for the direction to it. */
    LAMP_AS_DIRECTION,
    /** The light grows weaker with the distance of the eye. */
    WEAKENED_BY_THE_EYE,
    /** A lamp behind the face lights it as one before it. */
    LIT_FROM_BOTH_SIDES,
    /** The highlight is multiplied by n·l, too. */
    HIGHLIGHT_TIMES_COSINE;

    String word() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Red, green and blue at a place with that normal, not cut. */
    double[] sum(LitFace face, double[] place, double[] normal) {
        double[] n = normal.clone();
        double[] l =
                this == LAMP_AS_DIRECTION
                        ? face.lamp().clone()
                        : FacePoint.difference(face.lamp(), place);
        double[] v = FacePoint.difference(face.eye(), place);
        double distance = UnitVector.length(this == WEAKENED_BY_THE_EYE ? v : l);
        UnitVector.normalize(n);
        if (this != TO_LIGHT_NOT_NORMALIZED) UnitVector.normalize(l);
        if (this != TO_EYE_NOT_NORMALIZED) UnitVector.normalize(v);
        double cosine = dot(n, l);
        double shown = this == LIT_FROM_BOTH_SIDES ? Math.abs(cosine) : cosine;
        double mirrored = 2 * cosine * dot(n, v) - dot(l, v);
        if (this == MIRRORED_THE_WRONG_WAY) mirrored = -mirrored;
        double specular =
                shown > 0 ? Powers.of(Math.max(0, mirrored), face.material().shininess()) : 0;
        if (this == HIGHLIGHT_TIMES_COSINE) specular *= Math.max(0, cosine);
        double weaker = face.light().attenuation().factor(distance);
        return sum(
                face.material(),
                face.light(),
                face.globalAmbient(),
                weaker,
                Math.max(0, shown),
                specular);
    }

    private static double[] sum(
            SurfaceMaterial material,
            LightSource light,
            double[] globalAmbient,
            double weaker,
            double diffuse,
            double specular) {
        var sum = new double[3];
        for (int c = 0; c < 3; c++)
            sum[c] =
                    material.emission()[c]
                            + globalAmbient[c] * material.ambient()[c]
                            + weaker
                                    * (light.ambient()[c] * material.ambient()[c]
                                            + light.diffuse()[c] * material.diffuse()[c] * diffuse
                                            + light.specular()[c]
                                                    * material.specular()[c]
                                                    * specular);
        return sum;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
