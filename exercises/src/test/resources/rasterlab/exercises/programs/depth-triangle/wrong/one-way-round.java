import rasterlab.contract.DepthTriangleFiller;

/** Wrong: takes a centre for inside only where all areas are positive. */
public class OneWay implements DepthTriangleFiller {
    private static double side(
            double ax, double ay, double bx, double by, double px, double py) {
        return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
    }

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
        double area = side(x[0], y[0], x[1], y[1], x[2], y[2]);
        for (int at = 0; at < depths.length; at++) {
            int px = at % width;
            int py = at / width;
            double depth = 0;
            boolean inside = true;
            for (int i = 0; i < 3; i++) {
                int a = (i + 1) % 3;
                int b = (i + 2) % 3;
                double w = side(x[a], y[a], x[b], y[b], px, py);
                boolean leftOrTop = y[b] < y[a] || y[b] == y[a] && x[b] > x[a];
                if (w < 0 || w == 0 && !leftOrTop) inside = false;
                depth += w / area * z[i];
            }
            if (!inside || area <= 0 || !(depth < depths[at])) continue;
            depths[at] = depth;
            shown[at] = number;
        }
    }
}
