import rasterlab.contract.EyeView;

public class MyView implements EyeView {
    @Override
    public void view(double theta, double phi, double rho, double[] points) {
        double st = Math.sin(Math.toRadians(theta)), ct = Math.cos(Math.toRadians(theta));
        double sp = Math.sin(Math.toRadians(phi)), cp = Math.cos(Math.toRadians(phi));
        for (int i = 0; i < points.length; i += 3) {
            double x = points[i], y = points[i + 1], z = points[i + 2];
            double ahead = x * ct - y * st;
            points[i] = x * st + y * ct;
            points[i + 1] = z * sp - ahead * cp;
            points[i + 2] = rho - ahead * sp - z * cp;
        }
    }
}
