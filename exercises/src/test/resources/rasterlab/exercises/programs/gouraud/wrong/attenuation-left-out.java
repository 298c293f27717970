import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;

public class EverywhereAlike implements FaceShader {
    @Override
    public double[] shade(LitFace face, double[] weights) {
        double[][] corner = new double[3][];
        for (int k = 0; k < 3; k++) corner[k] = lit(face, at(face.corners(), k), unit(at(face.normals(), k)));
        double[] all = new double[weights.length];
        for (int i = 0; i < all.length; i++) {
            int point = i / 3 * 3;
            for (int k = 0; k < 3; k++) all[i] += weights[point + k] * corner[k][i % 3];
        }
        return all;
    }

    private static double[] lit(LitFace face, double[] p, double[] n) {
        double[] toLamp = minus(face.lamp(), p);
        double[] l = unit(toLamp);
        double[] v = unit(minus(face.eye(), p));
        double nl = dot(n, l);
        double rv = Math.max(0, 2 * nl * dot(n, v) - dot(l, v));
        double shine = nl > 0 ? Math.pow(rv, face.material().shininess()) : 0;
        double f = 1;
        double[] rgb = new double[3];
        for (int i = 0; i < 3; i++) {
            double own = face.light().ambient()[i] * face.material().ambient()[i];
            own += face.light().diffuse()[i] * face.material().diffuse()[i] * Math.max(0, nl);
            own += face.light().specular()[i] * face.material().specular()[i] * shine;
            double sum = face.material().emission()[i] + face.globalAmbient()[i] * face.material().ambient()[i];
            rgb[i] = Math.min(1, sum + f * own);
        }
        return rgb;
    }

    private static double[] at(double[] nine, int k) {
        return new double[] {nine[3 * k], nine[3 * k + 1], nine[3 * k + 2]};
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
