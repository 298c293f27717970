import rasterlab.contract.PlaneRotation;

public class Turn implements PlaneRotation {
    @Override
    public void rotate(double degrees, int times, double[] points) {
        if (times == 0) return;
        double s = Math.sin(Math.toRadians(degrees));
        double c = Math.cos(Math.toRadians(degrees));
        for (int i = 0; i < points.length; i += 2) {
            double x = points[i];
            points[i] = x * c - points[i + 1] * s;
            points[i + 1] = x * s + points[i + 1] * c;
        }
    }
}
