import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

/** Draws a circle. So far it draws nothing. */
public class MyCircle implements CircleRasterizer {
    @Override
    public void draw(int centerX, int centerY, int radius, Pixels out) {}
}
