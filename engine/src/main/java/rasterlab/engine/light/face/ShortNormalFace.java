package rasterlab.engine.light.face;

import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.Powers;
import rasterlab.engine.light.UnitVector;

/**
 * Phong's shading with the last step forgotten: mixed normals are not brought to length 1, so the
 * middle of a face is too dark and its highlight too weak.
 */
final class ShortNormalFace implements FaceShader {
    @Override
    public double[] shade(LitFace face, double[] weights) {
        FacePoint.requireWeights(weights);
        var shades = new double[weights.length];
        double[] normals = FacePoint.unit(face.normals());
        for (int i = 0; i < weights.length; i += 3) {
            double a = weights[i];
            double b = weights[i + 1];
            double c = weights[i + 2];
            point(
                    face,
                    FacePoint.mixed(face.corners(), a, b, c),
                    FacePoint.mixed(normals, a, b, c),
                    shades,
                    i);
        }
        return shades;
    }

    private static void point(LitFace face, double[] place, double[] n, double[] shades, int at) {
        double[] l = FacePoint.difference(face.lamp(), place);
        double[] v = FacePoint.difference(face.eye(), place);
        double strength = face.light().attenuation().factor(UnitVector.length(l));
        UnitVector.normalise(l);
        UnitVector.normalise(v);
        double cosine = Math.max(0, dot(n, l));
        double mirrored = Math.max(0, 2 * cosine * dot(n, v) - dot(l, v));
        double specular = cosine > 0 ? Powers.of(mirrored, face.material().shininess()) : 0;
        var material = face.material();
        var light = face.light();
        for (int c = 0; c < 3; c++)
            shades[at + c] =
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
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
