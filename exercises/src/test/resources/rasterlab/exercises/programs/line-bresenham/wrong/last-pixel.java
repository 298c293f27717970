import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class MyLine implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        int dx = Math.abs(x1 - x0), dy = Math.abs(y1 - y0);
        int sx = x0 < x1 ? 1 : -1, sy = y0 < y1 ? 1 : -1;
        int n = Math.max(dx, dy);
        int error = n - ((dx >= dy ? sy : sx) > 0 ? 1 : 0);
        int x = x0, y = y0;
        for (int k = 0; k < n; k++) {
            out.plot(x, y);
            error += 2 * Math.min(dx, dy);
            boolean across = error >= 2 * n;
            if (across) error -= 2 * n;
            if (dx >= dy || across) x += sx;
            if (dx < dy || across) y += sy;
        }
    }
}
