import java.util.stream.LongStream;
import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;

public class Formula implements WindowedLineRasterizer {
    record Pixel(long x, long y) {}

    // no state: pixel k is computed for itself, only for the k that the window leaves
    public void draw(int x0, int y0, int x1, int y1, int xmin, int ymin, int xmax, int ymax, Pixels out) {
        long dx = (long) x1 - x0;
        long dy = (long) y1 - y0;
        boolean wide = Math.abs(dx) >= Math.abs(dy);
        long n = wide ? Math.abs(dx) : Math.abs(dy);
        long start = wide ? x0 : y0;
        long step = Long.signum(wide ? dx : dy);
        long low = wide ? xmin : ymin;
        long high = wide ? xmax : ymax;
        long from = step > 0 ? low - start : step < 0 ? start - high : 0;
        long to = step > 0 ? high - start : step < 0 ? start - low : 0;
        LongStream.rangeClosed(Math.max(0, from), Math.min(n, to))
                .mapToObj(
                        k ->
                                wide
                                        ? new Pixel(x0 + k * step, y0 + share(k * dy, n))
                                        : new Pixel(x0 + share(k * dx, n), y0 + k * step))
                .filter(p -> p.x() >= xmin && p.x() <= xmax && p.y() >= ymin && p.y() <= ymax)
                .forEach(p -> out.plot((int) p.x(), (int) p.y()));
    }

    /** The nearest whole number to a/n, the smaller one of two. */
    private static long share(long a, long n) {
        return n == 0 ? 0 : -Math.floorDiv(n - 2 * a, 2 * n);
    }
}
