import rasterlab.contract.AxisRotation;

public class AboutOrigin implements AxisRotation {
    @Override
    public void rotate(double[] through, double[] direction, double degrees, double[] points) {
        double size = Math.sqrt(dot(direction, direction));
        double[] k = {direction[0] / size, direction[1] / size, direction[2] / size};
        double sin = Math.sin(Math.toRadians(degrees));
        double cos = Math.cos(Math.toRadians(degrees));
        for (int i = 0; i < points.length; i += 3) {
            double[] v = {points[i], points[i + 1], points[i + 2]};
            double[] turned = {k[1] * v[2] - k[2] * v[1], k[2] * v[0] - k[0] * v[2], k[0] * v[1] - k[1] * v[0]};
            double along = dot(k, v) * (1 - cos);
            for (int j = 0; j < 3; j++)
                points[i + j] = v[j] * cos + turned[j] * sin + k[j] * along;
        }
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
