import rasterlab.contract.*;

public class MyMethod implements CircleRasterizer {

    public void draw(int cx, int cy, int r, Pixels out) {
        for (int x = -r; x <= r; x++) {
            int y = (int) Math.round(Math.sqrt((double) r * r - (double) x * x));
            out.plot(cx + x, cy + y);
            if (y != 0) out.plot(cx + x, cy - y);
        }
    }
}
