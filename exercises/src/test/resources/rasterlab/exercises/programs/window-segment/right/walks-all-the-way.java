import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;

public class Walk implements WindowedLineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, int xmin, int ymin, int xmax, int ymax, Pixels out) {
        long dx = Math.abs((long) x1 - x0), dy = Math.abs((long) y1 - y0);
        int sx = x0 < x1 ? 1 : -1, sy = y0 < y1 ? 1 : -1;
        boolean steep = dy > dx;
        long n = steep ? dy : dx, b = steep ? dx : dy;
        // a tie goes to the smaller coordinate: who grows needs a bit more to step
        long error = n - ((steep ? sx : sy) > 0 ? 1 : 0);
        int x = x0, y = y0;
        for (long k = 0; k <= n; k++) {
            if (xmin <= x && x <= xmax && ymin <= y && y <= ymax) out.plot(x, y);
            error += 2 * b;
            boolean across = error >= 2 * n;
            if (across) error -= 2 * n;
            if (steep || across) y += sy;
            if (!steep || across) x += sx;
        }
    }
}
