import rasterlab.contract.EyeView;

/** Rotates about z towards the eye, then takes height and depth from there. */
public class Model implements EyeView {
    @Override
    public void view(double theta, double phi, double rho, double[] points) {
        double t = Math.toRadians(theta % 360);
        double p = Math.toRadians(phi % 360);
        double cosT = Math.cos(t);
        double sinT = Math.sin(t);
        double cosP = Math.cos(p);
        double sinP = Math.sin(p);
        for (int i = 0; i < points.length; i += 3) {
            double x = points[i];
            double y = points[i + 1];
            double z = points[i + 2];
            double towards = x * cosT + y * sinT;
            points[i] = y * cosT - x * sinT;
            points[i + 1] = z * sinP - towards * cosP;
            points[i + 2] = rho - towards * sinP - z * cosP;
        }
    }
}
