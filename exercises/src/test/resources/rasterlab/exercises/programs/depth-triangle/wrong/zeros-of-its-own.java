import rasterlab.contract.DepthTriangleFiller;

/** Wrong: compares with a buffer of its own, which is full of zeros. */
public class Own implements DepthTriangleFiller {
    @Override
    public void fill(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown) {
        double[] mine = new double[depths.length];
        double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (area == 0) return;
        double step = ((z[1] - z[0]) * (y[2] - y[0]) - (z[2] - z[0]) * (y[1] - y[0])) / area;
        double down = ((x[1] - x[0]) * (z[2] - z[0]) - (x[2] - x[0]) * (z[1] - z[0])) / area;
        for (int row = 0; row < height; row++) {
            double left = 1e9;
            double right = -1e9;
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                if ((y[i] <= row) == (y[j] <= row)) continue;
                double at = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                left = Math.min(left, at);
                right = Math.max(right, at);
            }
            int from = (int) Math.max(0, Math.ceil(left));
            int to = (int) Math.min(width, Math.ceil(right));
            double depth = z[0] + (from - x[0]) * step + (row - y[0]) * down;
            for (int column = from; column < to; column++) {
                int at = row * width + column;
                if (depth < mine[at]) {
                    mine[at] = depth;
                    shown[at] = number;
                }
                depth += step;
            }
        }
    }
}
