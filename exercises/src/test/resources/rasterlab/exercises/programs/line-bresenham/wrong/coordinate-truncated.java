import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class Dda implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        double dx = (double) x1 - x0;
        double dy = (double) y1 - y0;
        double steps = Math.max(Math.abs(dx), Math.abs(dy));
        double xStep = steps == 0 ? 0 : dx / steps;
        double yStep = steps == 0 ? 0 : dy / steps;
        for (long i = 0; i <= steps; i++)
            out.plot((int) (x0 + i * xStep), (int) (y0 + i * yStep));
    }
}
