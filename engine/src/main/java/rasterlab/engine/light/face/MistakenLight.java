package rasterlab.engine.light.face;

import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Powers;
import rasterlab.engine.light.UnitVector;

/** The formula with one mistake, as plain as books print it; without refusals. */
enum MistakenLight {
    /** The normal counts with the length that it has. */
    NORMAL_AS_GIVEN,
    /** The light is the same at every distance. */
    NOT_WEAKENED,
    /** Emission and light from everywhere grow weaker with the lamp's distance, too. */
    ALL_WEAKENED,
    /** A lamp behind the face takes light away. */
    COSINE_NOT_CUT,
    /** A lamp behind the face makes highlights. */
    HIGHLIGHT_FROM_BEHIND;

    /** Red, green and blue at a place with that normal, not cut. */
    double[] sum(LitFace face, double[] place, double[] normal) {
        double[] n = normal.clone();
        double[] l = FacePoint.difference(face.lamp(), place);
        double[] v = FacePoint.difference(face.eye(), place);
        double weaker = face.light().attenuation().factor(UnitVector.length(l));
        if (this != NORMAL_AS_GIVEN) UnitVector.normalize(n);
        UnitVector.normalize(l);
        UnitVector.normalize(v);
        double cosine = dot(n, l);
        double mirrored = Math.max(0, 2 * cosine * dot(n, v) - dot(l, v));
        boolean shines = cosine > 0 || this == HIGHLIGHT_FROM_BEHIND;
        double diffuse = this == COSINE_NOT_CUT ? cosine : Math.max(0, cosine);
        double specular = shines ? Powers.of(mirrored, face.material().shininess()) : 0;
        return sum(face, weaker, diffuse, specular);
    }

    private double[] sum(LitFace face, double weaker, double diffuse, double specular) {
        SurfaceMaterial material = face.material();
        LightSource light = face.light();
        double own = this == ALL_WEAKENED ? weaker : 1;
        double sent = this == NOT_WEAKENED ? 1 : weaker;
        var sum = new double[3];
        for (int c = 0; c < 3; c++) {
            double without =
                    material.emission()[c] + face.globalAmbient()[c] * material.ambient()[c];
            double with =
                    light.ambient()[c] * material.ambient()[c]
                            + light.diffuse()[c] * material.diffuse()[c] * diffuse
                            + light.specular()[c] * material.specular()[c] * specular;
            sum[c] = own * without + sent * with;
        }
        return sum;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
