import java.util.Arrays;
import rasterlab.contract.AxisRotation;

public class Frame implements AxisRotation {
    @Override
    public void rotate(double[] through, double[] direction, double degrees, double[] points) {
        double[] k = {0, 0, 1};
        double[] any = Math.abs(k[2]) < 0.7 ? new double[] {0, 0, 1} : new double[] {1, 0, 0};
        double[] u = unit(cross(any, k));
        double[] v = cross(k, u);
        double angle = Math.toRadians(Math.IEEEremainder(degrees, 360));
        for (int i = 0; i < points.length; i += 3) {
            double[] p = Arrays.copyOfRange(points, i, i + 3);
            for (int j = 0; j < 3; j++) p[j] -= through[j];
            double a = dot(p, u) * Math.cos(angle) - dot(p, v) * Math.sin(angle);
            double b = dot(p, u) * Math.sin(angle) + dot(p, v) * Math.cos(angle);
            double c = dot(p, k);
            for (int j = 0; j < 3; j++) points[i + j] = through[j] + a * u[j] + b * v[j] + c * k[j];
        }
    }

    private static double[] unit(double[] a) {
        double length = Math.sqrt(dot(a, a));
        return Arrays.stream(a).map(each -> each / length).toArray();
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
