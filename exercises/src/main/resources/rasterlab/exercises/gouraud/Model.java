import rasterlab.contract.FaceShader;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.SurfaceMaterial;

/**
 * Evaluates the formula at the three vertices, cuts each intensity to [0, 1] and mixes them by the
 * shares of every point. The light shines all around.
 *
 * <p>Source: H. Gouraud, Continuous shading of curved surfaces, IEEE Transactions on Computers
 * 20(6), 1971, pp. 623–629.
 */
public class Model implements FaceShader {
    @Override
    public double[] shade(LitFace face, double[] weights) {
        double[] first = vertex(face, 0);
        double[] second = vertex(face, 3);
        double[] third = vertex(face, 6);
        double[] shades = new double[weights.length];
        for (int i = 0; i < weights.length; i += 3)
            for (int k = 0; k < 3; k++)
                shades[i + k] =
                        weights[i] * first[k]
                                + weights[i + 1] * second[k]
                                + weights[i + 2] * third[k];
        return shades;
    }

    /** The formula at the vertex whose coordinates begin at that place. */
    private static double[] vertex(LitFace face, int at) {
        double[] n = unit(three(face.normals(), at));
        double[] p = three(face.corners(), at);
        double[] toLamp = difference(face.lamp(), p);
        double[] l = unit(toLamp);
        double[] v = unit(difference(face.eye(), p));
        SurfaceMaterial m = face.material();
        LightSource light = face.light();
        double nl = dot(n, l);
        double rv = 2 * nl * dot(n, v) - dot(l, v);
        double shine = nl > 0 ? Math.pow(Math.max(0, rv), m.shininess()) : 0;
        double weaker = light.attenuation().factor(Math.sqrt(dot(toLamp, toLamp)));
        double[] shade = new double[3];
        for (int k = 0; k < 3; k++) {
            double lit =
                    light.ambient()[k] * m.ambient()[k]
                            + light.diffuse()[k] * m.diffuse()[k] * Math.max(0, nl)
                            + light.specular()[k] * m.specular()[k] * shine;
            double sum = m.emission()[k] + face.globalAmbient()[k] * m.ambient()[k] + weaker * lit;
            shade[k] = Math.max(0, Math.min(1, sum));
        }
        return shade;
    }

    private static double[] three(double[] nine, int at) {
        return new double[] {nine[at], nine[at + 1], nine[at + 2]};
    }

    private static double[] difference(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double[] unit(double[] a) {
        double length = Math.sqrt(dot(a, a));
        return new double[] {a[0] / length, a[1] / length, a[2] / length};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
