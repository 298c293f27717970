import rasterlab.contract.DepthTriangleFiller;

/** Row by row: the depth at the first centre from the corners' weights, then a step per pixel. */
public class Model implements DepthTriangleFiller {
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
        double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (area == 0) return;
        double step =
                ((z[1] - z[0]) * (y[2] - y[0]) - (z[2] - z[0]) * (y[1] - y[0])) / area;
        double top = Math.min(y[0], Math.min(y[1], y[2]));
        double bottom = Math.max(y[0], Math.max(y[1], y[2]));
        for (int row = (int) Math.max(0, Math.ceil(top)); row < height && row < bottom; row++) {
            double left = Double.POSITIVE_INFINITY;
            double right = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                if ((y[i] <= row) == (y[j] <= row)) continue;
                double crossing = x[i] + (row - y[i]) * (x[j] - x[i]) / (y[j] - y[i]);
                left = Math.min(left, crossing);
                right = Math.max(right, crossing);
            }
            int from = (int) Math.max(0, Math.ceil(left));
            int to = (int) Math.min(width, Math.ceil(right));
            if (from >= to) continue;
            double depth = 0;
            for (int i = 0; i < 3; i++) {
                int a = (i + 1) % 3;
                int b = (i + 2) % 3;
                depth +=
                        ((x[b] - x[a]) * (row - y[a]) - (y[b] - y[a]) * (from - x[a]))
                                / area
                                * z[i];
            }
            for (int at = row * width + from; at < row * width + to; at++) {
                if (depth < depths[at]) {
                    depths[at] = depth;
                    shown[at] = number;
                }
                depth += step;
            }
        }
    }
}
