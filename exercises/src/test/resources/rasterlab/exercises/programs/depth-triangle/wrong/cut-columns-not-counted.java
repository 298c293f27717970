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
        double zx = ((z[1] - z[0]) * (y[2] - y[0]) - (z[2] - z[0]) * (y[1] - y[0])) / A,
                zy = ((x[1] - x[0]) * (z[2] - z[0]) - (x[2] - x[0]) * (z[1] - z[0])) / A;
        for (int row = 0; row < height; row++) {
            double lo = 1e300, hi = -1e300;
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                if ((y[i] <= row) != (y[j] <= row)) {
                    double X = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                    lo = Math.min(lo, X);
                    hi = Math.max(hi, X);
                }
            }
            if (lo > hi) continue;
            double d = z[0] + (Math.ceil(lo) - x[0]) * zx + (row - y[0]) * zy;
            for (int col = (int) Math.max(0, Math.ceil(lo));
                    col < Math.min(width, Math.ceil(hi));
                    col++) {
                int at = row * width + col;
                if (d < depths[at]) {
                    depths[at] = d;
                    shown[at] = number;
                }
                d += zx;
            }
        }
    }
}
