import rasterlab.contract.PlaneRotation;

public class Turn implements PlaneRotation {
    @Override
    public void rotate(double degrees, int times, double[] points) {
        double s = Math.sin(Math.toRadians(degrees));
        double c = Math.cos(Math.toRadians(degrees));
        for (int i = 0; i < points.length; i += 2) {
            double x = points[i];
            double y = points[i + 1];
            for (int k = 0; k < times; k++) {
                double turned = x * c + y * s;
                y = y * c - x * s;
                x = turned;
            }
            points[i] = x;
            points[i + 1] = y;
        }
    }
}
