import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

public class Circle implements CircleRasterizer {
    @Override
    public void draw(int cx, int cy, int r, Pixels out) {
        int x = 0;
        int y = r;
        int d = 1 - r;
        while (x <= y) {
            out.plot(cx + x, cy + y);
            out.plot(cx - x, cy + y);
            out.plot(cx + x, cy - y);
            out.plot(cx - x, cy - y);
            out.plot(cx + y, cy + x);
            out.plot(cx - y, cy + x);
            out.plot(cx + y, cy - x);
            out.plot(cx - y, cy - x);
            if (d < 0) d += 2 * x + 3;
            else {
                d += 2 * (x - y) + 5;
                y--;
            }
            x++;
        }
    }
}
