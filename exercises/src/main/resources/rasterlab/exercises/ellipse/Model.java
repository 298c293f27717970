import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;

/** Takes the columns of a quadrant, then the rows whose pixel no column has, in long numbers. */
public class Model implements EllipseRasterizer {
    @Override
    public void draw(int centerX, int centerY, int radiusX, int radiusY, Pixels out) {
        long aa = (long) radiusX * radiusX;
        long bb = (long) radiusY * radiusY;
        int[] rows = new int[radiusX + 1];
        int v = radiusY;
        for (int u = 0; u <= radiusX; u++) {
            while (v > 0 && far(v, aa, bb, u)) v--;
            rows[u] = v;
            sides(centerX, centerY, u, v, out);
        }
        int u = radiusX;
        for (v = 0; v <= radiusY; v++) {
            while (u > 0 && far(u, bb, aa, v)) u--;
            if (rows[u] != v) sides(centerX, centerY, u, v, out);
        }
    }

    /** Whether the curve runs at least half a pixel below v. */
    private static boolean far(long v, long aa, long bb, long u) {
        return (2 * v - 1) * (2 * v - 1) * aa >= 4 * bb * (aa - u * u);
    }

    /** Plots the pixels (±u, ±v), each once. */
    private static void sides(int x, int y, int u, int v, Pixels out) {
        out.plot(x + u, y + v);
        if (u != 0) out.plot(x - u, y + v);
        if (v == 0) return;
        out.plot(x + u, y - v);
        if (u != 0) out.plot(x - u, y - v);
    }
}
