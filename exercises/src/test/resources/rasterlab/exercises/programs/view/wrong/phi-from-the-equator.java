import rasterlab.contract.EyeView;

public class Latitude implements EyeView {
    @Override
    public void view(double theta, double phi, double rho, double[] points) {
        double t = Math.toRadians(theta);
        double f = Math.toRadians(phi);
        for (int i = 0; i < points.length; i += 3) {
            double x = points[i], y = points[i + 1], z = points[i + 2];
            double along = x * Math.cos(t) + y * Math.sin(t);
            points[i] = y * Math.cos(t) - x * Math.sin(t);
            points[i + 1] = z * Math.cos(f) - along * Math.sin(f);
            points[i + 2] = rho - along * Math.cos(f) - z * Math.sin(f);
        }
    }
}
