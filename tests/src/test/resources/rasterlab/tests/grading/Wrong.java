import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class Wrong implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        for (int x = x0; x < x1; x++) out.plot(x, y0 + (y1 - y0) * (x - x0) / (x1 - x0));
    }
}
