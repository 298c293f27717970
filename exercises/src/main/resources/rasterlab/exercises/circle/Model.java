import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

/** Goes along one octant and mirrors each of its pixels, in long numbers. */
public class Model implements CircleRasterizer {
    @Override
    public void draw(int centerX, int centerY, int radius, Pixels out) {
        long square = (long) radius * radius;
        int v = radius;
        for (int u = 0; ; u++) {
            while (v > 0 && (long) u * u + (long) v * v - v >= square) v--;
            if (u > v) return;
            sides(centerX, centerY, u, v, out);
            if (u != v) sides(centerX, centerY, v, u, out);
        }
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
