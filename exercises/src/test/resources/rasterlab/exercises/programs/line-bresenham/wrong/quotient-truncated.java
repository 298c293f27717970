import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class Interpolated implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        long dx = (long) x1 - x0, dy = (long) y1 - y0;
        long n = Math.max(Math.abs(dx), Math.abs(dy));
        if (n == 0) {
            out.plot(x0, y0);
            return;
        }
        for (long i = 0; i <= n; i++)
            out.plot((int) (x0 + i * dx / n), (int) (y0 + i * dy / n));
    }
}
