package rasterlab.engine.light.face;

import rasterlab.contract.LitFace;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.Powers;
import rasterlab.engine.light.UnitVector;

/**
 * Phong's shading with the last step forgotten: mixed normals are not brought to length 1, so the
 * middle of a face is too dark and its highlight too weak.
 */
final class ShortNormalFace implements SteppedFace {
    @Override
    public double[] shade(LitFace face, double[] weights, Evaluations told) {
        FacePoint.requireWeights(weights);
        var shades = new double[weights.length];
        double[] normals = FacePoint.unit(face.normals());
        for (int i = 0; i < weights.length; i += 3) {
            double a = weights[i];
            double b = weights[i + 1];
            double c = weights[i + 2];
            double[] place = FacePoint.mixed(face.corners(), a, b, c);
            double[] normal = FacePoint.mixed(normals, a, b, c);
            double[] shade = intensity(face, place, normal);
            told.at(place, normal, shade);
            System.arraycopy(shade, 0, shades, i, 3);
        }
        return shades;
    }

    private static double[] intensity(LitFace face, double[] place, double[] n) {
        double[] l = FacePoint.difference(face.lamp(), place);
        double[] v = FacePoint.difference(face.eye(), place);
        double strength = face.light().attenuation().factor(UnitVector.length(l));
        UnitVector.normalize(l);
        UnitVector.normalize(v);
        double cosine = Math.max(0, dot(n, l));
        double mirrored = Math.max(0, 2 * cosine * dot(n, v) - dot(l, v));
        double specular = cosine > 0 ? Powers.of(mirrored, face.material().shininess()) : 0;
        var material = face.material();
        var light = face.light();
        var shade = new double[3];
        for (int c = 0; c < 3; c++)
            shade[c] =
                    Levels.cut(
                            material.emission()[c]
                                    + face.globalAmbient()[c] * material.ambient()[c]
                                    + strength
                                            * (light.ambient()[c] * material.ambient()[c]
                                                    + light.diffuse()[c]
                                                            * material.diffuse()[c]
                                                            * cosine
                                                    + light.specular()[c]
                                                            * material.specular()[c]
                                                            * specular));
        return shade;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
