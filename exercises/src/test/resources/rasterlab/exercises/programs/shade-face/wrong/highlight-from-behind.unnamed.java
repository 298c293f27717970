import rasterlab.contract.*;

public class MyMethod implements FaceShader {

    static double[] unit(double x, double y, double z) {
        double l = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / l, y / l, z / l};
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    public double[] shade(LitFace face, double[] w) {
        double[] out = new double[w.length],
                c = face.corners(),
                q = face.normals(),
                lamp = face.lamp(),
                eye = face.eye();
        double[][] ns = new double[3][];
        for (int i = 0; i < 3; i++) ns[i] = unit(q[3 * i], q[3 * i + 1], q[3 * i + 2]);
        SurfaceMaterial m = face.material();
        LightSource s = face.light();
        for (int i = 0; i < w.length; i += 3) {
            double[] p = new double[3], n = new double[3];
            for (int v = 0; v < 3; v++)
                for (int k = 0; k < 3; k++) {
                    p[k] += w[i + v] * c[3 * v + k];
                    n[k] += w[i + v] * ns[v][k];
                }
            n = unit(n[0], n[1], n[2]);
            double[] tl = {lamp[0] - p[0], lamp[1] - p[1], lamp[2] - p[2]};
            double d = Math.sqrt(dot(tl, tl));
            double[] l = unit(tl[0], tl[1], tl[2]),
                    e = unit(eye[0] - p[0], eye[1] - p[1], eye[2] - p[2]);
            double nl = dot(n, l),
                    f = s.attenuation().factor(d),
                    high = Math.pow(Math.max(0, 2 * nl * dot(n, e) - dot(l, e)), m.shininess());
            for (int k = 0; k < 3; k++)
                out[i + k] =
                        Math.max(
                                0,
                                Math.min(
                                        1,
                                        m.emission()[k]
                                                + face.globalAmbient()[k] * m.ambient()[k]
                                                + f
                                                        * (s.ambient()[k] * m.ambient()[k]
                                                                + s.diffuse()[k]
                                                                        * m.diffuse()[k]
                                                                        * Math.max(0, nl)
                                                                + s.specular()[k]
                                                                        * m.specular()[k]
                                                                        * high)));
        }
        return out;
    }
}
