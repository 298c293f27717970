import rasterlab.contract.*;

import java.util.stream.*;

public class MyMethod implements LineRasterizer {

    record P(long x, long y) {}

    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        long dx = (long) x1 - x0, dy = (long) y1 - y0, n = Math.max(Math.abs(dx), Math.abs(dy));
        LongStream.rangeClosed(0, n)
                .mapToObj(
                        k -> n == 0 ? new P(x0, y0) : new P(near(x0, k, dx, n), near(y0, k, dy, n)))
                .forEachOrdered(p -> out.plot((int) p.x(), (int) p.y()));
    }

    private static long near(long from, long k, long d, long n) {
        return from - Math.floorDiv(-2 * k * d + n, 2 * n);
    }
}
