import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

public class Circle implements CircleRasterizer {
    @Override
    public void draw(int cx, int cy, int r, Pixels out) {
        for (int u = 0; ; u++) {
            int v = (int) Math.sqrt((double) r * r - (double) u * u);
            if (u > v) return;
            four(cx, cy, u, v, out);
            if (u != v) four(cx, cy, v, u, out);
        }
    }

    private void four(int cx, int cy, int u, int v, Pixels out) {
        out.plot(cx + u, cy + v);
        if (u > 0) out.plot(cx - u, cy + v);
        if (v > 0) out.plot(cx + u, cy - v);
        if (u > 0 && v > 0) out.plot(cx - u, cy - v);
    }
}
