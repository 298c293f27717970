import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;

/** Draws an ellipse. So far it draws nothing. */
public class MyEllipse implements EllipseRasterizer {
    @Override
    public void draw(int centerX, int centerY, int radiusX, int radiusY, Pixels out) {}
}
