import rasterlab.contract.EyeView;

public class NoRadians implements EyeView {
    @Override
    public void view(double theta, double phi, double rho, double[] points) {
        double st = Math.sin(theta), ct = Math.cos(theta), sp = Math.sin(phi), cp = Math.cos(phi);
        for (int i = 0; i < points.length; i += 3) {
            double x = points[i], y = points[i + 1], z = points[i + 2];
            points[i] = y * ct - x * st;
            points[i + 1] = z * sp - (x * ct + y * st) * cp;
            points[i + 2] = rho - (x * ct + y * st) * sp - z * cp;
        }
    }
}
