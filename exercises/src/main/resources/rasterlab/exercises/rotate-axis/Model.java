import rasterlab.contract.AxisRotation;

/** Rodrigues' formula, with the direction scaled before its length is taken. */
public class Model implements AxisRotation {
    @Override
    public void rotate(double[] through, double[] direction, double degrees, double[] points) {
        double[] k = unit(direction);
        double angle = Math.toRadians(degrees % 360);
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        for (int i = 0; i < points.length; i += 3) {
            double x = points[i] - through[0];
            double y = points[i + 1] - through[1];
            double z = points[i + 2] - through[2];
            double along = (k[0] * x + k[1] * y + k[2] * z) * (1 - cos);
            points[i] = through[0] + x * cos + (k[1] * z - k[2] * y) * sin + k[0] * along;
            points[i + 1] = through[1] + y * cos + (k[2] * x - k[0] * z) * sin + k[1] * along;
            points[i + 2] = through[2] + z * cos + (k[0] * y - k[1] * x) * sin + k[2] * along;
        }
    }

    /** The direction with length 1; neither a huge nor a tiny square can spoil it. */
    private static double[] unit(double[] d) {
        double largest = Math.max(Math.abs(d[0]), Math.max(Math.abs(d[1]), Math.abs(d[2])));
        double x = d[0] / largest;
        double y = d[1] / largest;
        double z = d[2] / largest;
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }
}
