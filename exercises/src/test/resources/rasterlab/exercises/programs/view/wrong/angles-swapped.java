import rasterlab.contract.*;

public class MyMethod implements EyeView {

    public void view(double phi, double theta, double rho, double[] p) {
        double t = Math.toRadians(theta),
                f = Math.toRadians(phi),
                ct = Math.cos(t),
                st = Math.sin(t),
                cp = Math.cos(f),
                sp = Math.sin(f);
        for (int i = 0; i < p.length; i += 3) {
            double x = p[i], y = p[i + 1], z = p[i + 2];
            p[i] = y * ct - x * st;
            p[i + 1] = z * sp - (x * ct + y * st) * cp;
            p[i + 2] = rho - (x * ct + y * st) * sp - z * cp;
        }
    }
}
