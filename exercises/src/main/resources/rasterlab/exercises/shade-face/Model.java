import rasterlab.contract.FaceShader;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.SurfaceMaterial;

/**
 * Mixes the corners' unit normals, brings them to length 1 and evaluates Phong's formula at every
 * point. The light shines all around.
 *
 * <p>Source: B. T. Phong, Illumination for computer generated pictures, Communications of the ACM
 * 18(6), 1975, pp. 311–317.
 */
public class Model implements FaceShader {
    @Override
    public double[] shade(LitFace face, double[] weights) {
        double[] normals = face.normals().clone();
        for (int k = 0; k < 9; k += 3)
            System.arraycopy(unit(normals[k], normals[k + 1], normals[k + 2]), 0, normals, k, 3);
        double[] shades = new double[weights.length];
        for (int i = 0; i < weights.length; i += 3)
            System.arraycopy(
                    shade(face, mixed(face.corners(), weights, i), mixed(normals, weights, i)),
                    0,
                    shades,
                    i,
                    3);
        return shades;
    }

    /** The formula at the point p, where the mixed normal is n. */
    private static double[] shade(LitFace face, double[] p, double[] n) {
        double[] toLamp = difference(face.lamp(), p);
        double[] toEye = difference(face.eye(), p);
        double distance = Math.sqrt(dot(toLamp, toLamp));
        double[] normal = unit(n[0], n[1], n[2]);
        double[] l = unit(toLamp[0], toLamp[1], toLamp[2]);
        double[] v = unit(toEye[0], toEye[1], toEye[2]);
        SurfaceMaterial m = face.material();
        LightSource light = face.light();
        double nl = dot(normal, l);
        double rv = 2 * nl * dot(normal, v) - dot(l, v);
        double shine = nl > 0 ? Math.pow(Math.max(0, rv), m.shininess()) : 0;
        double weaker = light.attenuation().factor(distance);
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

    private static double[] difference(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double[] mixed(double[] three, double[] weights, int i) {
        double[] sum = new double[3];
        for (int k = 0; k < 3; k++)
            sum[k] =
                    weights[i] * three[k]
                            + weights[i + 1] * three[k + 3]
                            + weights[i + 2] * three[k + 6];
        return sum;
    }

    private static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
