import rasterlab.contract.*;

public class MyMethod implements DepthTriangleFiller {

    public void fill(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown) {
        double A = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (A == 0) return;
        for (int row = 0; row < height; row++) {
            double lo = Double.POSITIVE_INFINITY, hi = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                if ((y[i] < row) != (y[j] < row)) {
                    double X = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                    lo = Math.min(lo, X);
                    hi = Math.max(hi, X);
                }
            }
            if (lo > hi) continue;
            for (int col = (int) Math.max(0, Math.ceil(lo));
                    col < Math.min(width, Math.ceil(hi));
                    col++) {
                double b = ((col - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (row - y[0])) / A,
                        c = ((x[1] - x[0]) * (row - y[0]) - (col - x[0]) * (y[1] - y[0])) / A;
                double d = z[0] * (1 - b - c) + z[1] * b + z[2] * c;
                int at = row * width + col;
                if (d < depths[at]) {
                    depths[at] = d;
                    shown[at] = number;
                }
            }
        }
    }
}
