import rasterlab.contract.AxisRotation;

public class MatrixRotation implements AxisRotation {
    @Override
    public void rotate(double[] through, double[] direction, double degrees, double[] points) {
        double length = Math.hypot(Math.hypot(direction[0], direction[1]), direction[2]);
        double x = direction[0] / length, y = direction[1] / length, z = direction[2] / length;
        double c = Math.cos(Math.toRadians(degrees)), s = Math.sin(Math.toRadians(degrees)), t = 1 - c;
        // written for row vectors, used for columns
        double[][] m = {
            {t * x * x + c, t * x * y + s * z, t * x * z - s * y},
            {t * x * y - s * z, t * y * y + c, t * y * z + s * x},
            {t * x * z + s * y, t * y * z - s * x, t * z * z + c}
        };
        for (int i = 0; i < points.length; i += 3) {
            double u = points[i] - through[0], v = points[i + 1] - through[1], w = points[i + 2] - through[2];
            for (int j = 0; j < 3; j++)
                points[i + j] = through[j] + m[j][0] * u + m[j][1] * v + m[j][2] * w;
        }
    }
}
