import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;

public class MyLine implements WindowedLineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, int xmin, int ymin, int xmax, int ymax, Pixels out) {
        long n = Math.max(Math.abs((long) x1 - x0), Math.abs((long) y1 - y0));
        for (long k = 0; k <= n; k++) {
            long x = x0 + share(k * ((long) x1 - x0), n);
            long y = y0 + share(k * ((long) y1 - y0), n);
            if (x >= xmin && x <= xmax && y >= ymin && y <= ymax) out.plot((int) x, (int) y);
        }
    }

    private static long share(long a, long n) {
        return n == 0 ? 0 : Math.floorDiv(2 * a + n, 2 * n);
    }
}
