import rasterlab.contract.PlaneRotation;

public class Turn implements PlaneRotation {
    @Override
    public void rotate(double degrees, int times, double[] points) {
        double s = Math.sin(Math.toRadians(degrees));
        double c = Math.cos(Math.toRadians(degrees));
        for (int i = 0; i < points.length; i += 2)
            for (int k = 0; k < times; k++) {
                points[i] = points[i] * c - points[i + 1] * s;
                points[i + 1] = points[i] * s + points[i + 1] * c;
            }
    }
}
