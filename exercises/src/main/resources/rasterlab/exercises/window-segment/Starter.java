import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;

/** Draws the part of a segment that lies in a window. So far it draws nothing. */
public class MyWindowedLine implements WindowedLineRasterizer {
    @Override
    public void draw(
            int x0, int y0, int x1, int y1, int xmin, int ymin, int xmax, int ymax, Pixels out) {}
}
