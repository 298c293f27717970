import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;

/** Begins at the first step within the window along the longer axis, with that step's remainder. */
public class Model implements WindowedLineRasterizer {
    @Override
    public void draw(
            int x0, int y0, int x1, int y1, int xmin, int ymin, int xmax, int ymax, Pixels out) {
        boolean steep = Math.abs((long) y1 - y0) > Math.abs((long) x1 - x0);
        if (steep) draw(y0, x0, y1, x1, ymin, xmin, ymax, xmax, true, out);
        else draw(x0, y0, x1, y1, xmin, ymin, xmax, ymax, false, out);
    }

    /** The longer axis comes first in each pair. */
    private static void draw(
            long a0,
            long b0,
            long a1,
            long b1,
            long amin,
            long bmin,
            long amax,
            long bmax,
            boolean steep,
            Pixels out) {
        int signA = a1 < a0 ? -1 : 1;
        int signB = b1 < b0 ? -1 : 1;
        long n = Math.abs(a1 - a0);
        long rise = Math.abs(b1 - b0);
        long first = Math.max(0, signA > 0 ? amin - a0 : a0 - amax);
        long last = Math.min(n, signA > 0 ? amax - a0 : a0 - amin);
        if (first > last) return;
        // pixel k lies (2·k·rise + n − tie) / (2·n) across, rounded down
        long numerator = 2 * first * rise + n - (signB > 0 ? 1 : 0);
        long across = n == 0 ? 0 : Math.floorDiv(numerator, 2 * n);
        long remainder = numerator - across * 2 * n;
        long b = b0 + signB * across;
        for (long k = first; k <= last; k++) {
            if (b >= bmin && b <= bmax) {
                int a = (int) (a0 + signA * k);
                out.plot(steep ? (int) b : a, steep ? a : (int) b);
            }
            remainder += 2 * rise;
            if (remainder >= 2 * n) {
                remainder -= 2 * n;
                b += signB;
            }
        }
    }
}
