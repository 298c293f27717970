import rasterlab.contract.*;

public class MyMethod implements AxisRotation {

    public void rotate(double[] c, double[] dir, double degrees, double[] p) {
        double len = Math.sqrt(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2]);
        double kx = dir[0] / len, ky = dir[1] / len, kz = dir[2] / len;
        double a = Math.toRadians(degrees), cos = Math.cos(a), sin = Math.sin(a);
        for (int i = 0; i < p.length; i += 3) {
            p[i] -= c[0];
            p[i + 1] -= c[1];
            p[i + 2] -= c[2];
            double dot = (kx * p[i] + ky * p[i + 1] + kz * p[i + 2]) * (1 - cos);

            p[i] = p[i] * cos + (ky * p[i + 2] - kz * p[i + 1]) * sin + kx * dot;
            p[i + 1] = p[i + 1] * cos + (kz * p[i] - kx * p[i + 2]) * sin + ky * dot;
            p[i + 2] = p[i + 2] * cos + (kx * p[i + 1] - ky * p[i]) * sin + kz * dot;
            p[i] += c[0];
            p[i + 1] += c[1];
            p[i + 2] += c[2];
        }
    }
}
