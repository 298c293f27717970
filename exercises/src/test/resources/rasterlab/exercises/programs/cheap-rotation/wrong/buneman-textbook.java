import rasterlab.contract.PlaneRotation;

public class Turn implements PlaneRotation {
    @Override
    public void rotate(double degrees, int times, double[] points) {
        double angle = Math.toRadians(degrees);
        double t = Math.tan(angle / 2);
        double sin = Math.sin(angle);
        for (int i = 0; i < points.length; i += 2)
            for (int k = 0; k < times; k++) {
                double shifted = points[i + 1] + points[i] * t;
                points[i] = points[i] - shifted * sin;
                points[i + 1] = points[i] * t + shifted;
            }
    }
}
