import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class BySlope implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        int dx = x1 - x0, dy = y1 - y0;
        if (dx == 0 && dy == 0) {
            out.plot(x0, y0);
        } else if (Math.abs(dx) >= Math.abs(dy)) {
            double slope = dy / dx;
            int step = dx > 0 ? 1 : -1;
            for (int x = x0; x != x1 + step; x += step)
                out.plot(x, (int) Math.round(y0 + slope * (x - x0)));
        } else {
            double slope = dx / dy;
            int step = dy > 0 ? 1 : -1;
            for (int y = y0; y != y1 + step; y += step)
                out.plot((int) Math.round(x0 + slope * (y - y0)), y);
        }
    }
}
