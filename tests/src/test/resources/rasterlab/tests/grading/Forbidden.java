import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

public class Forbidden implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        System.exit(0);
    }
}
