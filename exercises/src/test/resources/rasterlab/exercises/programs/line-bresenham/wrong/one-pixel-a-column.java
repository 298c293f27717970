import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class ByColumns implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        if (x0 == x1) {
            out.plot(x0, y0);
            return;
        }
        int step = x0 < x1 ? 1 : -1;
        double slope = ((double) y1 - y0) / ((double) x1 - x0);
        for (int x = x0; x != x1 + step; x += step)
            out.plot(x, (int) Math.ceil(y0 + slope * (x - x0) - 0.5));
    }
}
