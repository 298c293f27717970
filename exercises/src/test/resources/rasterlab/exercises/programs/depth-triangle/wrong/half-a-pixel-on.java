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
        double A = w(x[0], y[0], x[1], y[1], x[2], y[2]);
        if (A == 0) return;
        int[] o = A > 0 ? new int[] {0, 1, 2} : new int[] {0, 2, 1};
        A = Math.abs(A);
        for (int r = 0; r < height; r++)
            for (int c = 0; c < width; c++) {
                double[] e = new double[3];
                boolean in = true;
                for (int k = 0; k < 3 && in; k++) {
                    int i = o[(k + 1) % 3], j = o[(k + 2) % 3];
                    e[k] = w(x[i], y[i], x[j], y[j], c + 0.5, r + 0.5);
                    boolean topLeft = y[i] == y[j] && x[j] > x[i] || y[j] < y[i];
                    in = e[k] > 0 || e[k] == 0 && topLeft;
                }
                if (!in) continue;
                double d = (e[0] * z[o[0]] + e[1] * z[o[1]] + e[2] * z[o[2]]) / A;
                int at = r * width + c;
                if (d < depths[at]) {
                    depths[at] = d;
                    shown[at] = number;
                }
            }
    }

    static double w(double ax, double ay, double bx, double by, double px, double py) {
        return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    }
}
