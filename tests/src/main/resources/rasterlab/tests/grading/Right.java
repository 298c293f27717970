import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class Right implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        long dx = Math.abs((long) x1 - x0);
        long dy = Math.abs((long) y1 - y0);
        int stepX = x1 < x0 ? -1 : 1;
        int stepY = y1 < y0 ? -1 : 1;
        boolean wide = dx >= dy;
        long longer = Math.max(dx, dy);
        long shorter = Math.min(dx, dy);
        int across = wide ? stepY : stepX;
        long decision = 2 * shorter - longer + (across < 0 ? 1 : 0);
        int x = x0;
        int y = y0;
        for (long left = longer; left >= 0; left--) {
            out.plot(x, y);
            if (decision > 0) {
                if (wide) y += stepY;
                else x += stepX;
                decision -= 2 * longer;
            }
            decision += 2 * shorter;
            if (wide) x += stepX;
            else y += stepY;
        }
    }
}
