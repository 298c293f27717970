import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;

public class AsGiven implements FaceShader {
    @Override
    public double[] shade(LitFace face, double[] weights) {
        double[] normals = face.normals();
        double[] all = new double[weights.length];
        for (int i = 0; i < all.length; i += 3) {
            double a = weights[i], b = weights[i + 1], c = weights[i + 2];
            double[] n = unit(mix(normals, a, b, c));
            System.arraycopy(lit(face, mix(face.corners(), a, b, c), n), 0, all, i, 3);
        }
        return all;
    }

    private static double[] lit(LitFace face, double[] p, double[] n) {
        double[] toLamp = minus(face.lamp(), p);
        double[] l = unit(toLamp);
        double[] v = unit(minus(face.eye(), p));
        double nl = dot(n, l);
        double shine = 0;
        if (nl > 0) shine = Math.pow(Math.max(0, 2 * nl * dot(n, v) - dot(l, v)), face.material().shininess());
        double f = face.light().attenuation().factor(Math.sqrt(dot(toLamp, toLamp)));
        double[] rgb = new double[3];
        for (int i = 0; i < 3; i++) {
            double own = face.light().ambient()[i] * face.material().ambient()[i];
            own += face.light().diffuse()[i] * face.material().diffuse()[i] * Math.max(0, nl);
            own += face.light().specular()[i] * face.material().specular()[i] * shine;
            double glow = face.material().emission()[i];
            rgb[i] = Math.min(1, glow + face.globalAmbient()[i] * face.material().ambient()[i] + f * own);
        }
        return rgb;
    }

    private static double[] mix(double[] nine, double a, double b, double c) {
        double[] sum = new double[3];
        for (int i = 0; i < 3; i++) sum[i] = a * nine[i] + b * nine[3 + i] + c * nine[6 + i];
        return sum;
    }

    private static double[] units(double[] nine) {
        double[] all = new double[9];
        for (int k = 0; k < 9; k += 3) {
            double[] one = unit(new double[] {nine[k], nine[k + 1], nine[k + 2]});
            System.arraycopy(one, 0, all, k, 3);
        }
        return all;
    }

    private static double[] unit(double[] a) {
        double size = Math.sqrt(dot(a, a));
        return new double[] {a[0] / size, a[1] / size, a[2] / size};
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
