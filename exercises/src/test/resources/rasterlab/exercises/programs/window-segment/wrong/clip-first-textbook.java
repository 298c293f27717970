import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;

public class ClipAndDraw implements WindowedLineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, int xmin, int ymin, int xmax, int ymax, Pixels out) {
        // Liang-Barsky, then a line between the rounded ends
        double dx = (double) x1 - x0;
        double dy = (double) y1 - y0;
        double[] p = {-dx, dx, -dy, dy};
        double[] q = {(double) x0 - xmin, (double) xmax - x0, (double) y0 - ymin, (double) ymax - y0};
        double in = 0;
        double leave = 1;
        for (int i = 0; i < 4; i++) {
            if (p[i] == 0 && q[i] < 0) return;
            if (p[i] < 0) in = Math.max(in, q[i] / p[i]);
            if (p[i] > 0) leave = Math.min(leave, q[i] / p[i]);
        }
        if (in > leave) return;
        line(
                (int) Math.rint(x0 + in * dx),
                (int) Math.rint(y0 + in * dy),
                (int) Math.rint(x0 + leave * dx),
                (int) Math.rint(y0 + leave * dy),
                out);
    }

    private static void line(int x0, int y0, int x1, int y1, Pixels out) {
        long n = Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0));
        for (long k = 0; k <= n; k++)
            out.plot((int) (x0 + share(k * (x1 - x0), n)), (int) (y0 + share(k * (y1 - y0), n)));
    }

    private static long share(long a, long n) {
        return n == 0 ? 0 : -Math.floorDiv(n - 2 * a, 2 * n);
    }
}
