import rasterlab.contract.*;

public class MyMethod implements PlaneRotation {

    public void rotate(double degrees, int times, double[] p) {
        double a = Math.toRadians(degrees), c = Math.cos(a), s = Math.sin(a);
        for (int i = 0; i < p.length; i += 2)
            for (int k = 0; k <= times; k++) {
                double x = p[i];
                p[i] = x * c - p[i + 1] * s;
                p[i + 1] = x * s + p[i + 1] * c;
            }
    }
}
