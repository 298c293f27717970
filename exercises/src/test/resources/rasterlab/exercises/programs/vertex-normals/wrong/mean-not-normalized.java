import rasterlab.contract.*;

public class MyMethod implements VertexNormals {

    public double[] normals(double[] v, int[] t) {
        double[] s = new double[v.length], w = new double[v.length / 3];
        for (int i = 0; i < t.length; i += 3) {
            int a = 3 * t[i], b = 3 * t[i + 1], c = 3 * t[i + 2];
            double ux = v[b] - v[a],
                    uy = v[b + 1] - v[a + 1],
                    uz = v[b + 2] - v[a + 2],
                    wx = v[c] - v[a],
                    wy = v[c + 1] - v[a + 1],
                    wz = v[c + 2] - v[a + 2];
            double x = uy * wz - uz * wy,
                    y = uz * wx - ux * wz,
                    z = ux * wy - uy * wx,
                    l = Math.sqrt(x * x + y * y + z * z);
            for (int k : new int[] {a, b, c}) {
                s[k] += x;
                s[k + 1] += y;
                s[k + 2] += z;
                w[k / 3] += l;
            }
        }
        for (int i = 0; i < s.length; i += 3) {
            double l = Math.sqrt(s[i] * s[i] + s[i + 1] * s[i + 1] + s[i + 2] * s[i + 2]);
            int n = 0;
            for (int q : t) if (3 * q == i) n++;
            if (n > 0) {
                s[i] /= n;
                s[i + 1] /= n;
                s[i + 2] /= n;
            }
        }
        return s;
    }
}
