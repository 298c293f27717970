import rasterlab.contract.*;

public class MyMethod implements AxisRotation {

    public void rotate(double[] c, double[] dir, double degrees, double[] p) {
        double len = Math.sqrt(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2]);
        double kx = dir[0] / len, ky = dir[1] / len, kz = dir[2] / len;
        double a = Math.toRadians(degrees), cos = Math.cos(a), sin = Math.sin(a);
        for (int i = 0; i < p.length; i += 3) {
            double x = p[i] - c[0], y = p[i + 1] - c[1], z = p[i + 2] - c[2];
            double dot = (kx * x + ky * y + kz * z) * (1 - cos);
            p[i] = c[0] + x * cos + (ky * z - kz * y) * sin;
            p[i + 1] = c[1] + y * cos + (kz * x - kx * z) * sin;
            p[i + 2] = c[2] + z * cos + (kx * y - ky * x) * sin;
        }
    }
}
