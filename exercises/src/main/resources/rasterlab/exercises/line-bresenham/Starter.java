import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;

/** Draws a straight line. So far only its first pixel. */
public class MyLine implements LineRasterizer {
    @Override
    public void draw(int x0, int y0, int x1, int y1, Pixels out) {
        out.plot(x0, y0);
    }
}
