import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;

public class MyEllipse implements EllipseRasterizer {
    @Override
    public void draw(int cx, int cy, int a, int b, Pixels out) {
        for (int u = 0; u <= a; u++) {
            double share = a == 0 ? 0 : (double) u / a;
            int v = (int) Math.round(b * Math.sqrt(1 - share * share));
            out.plot(cx + u, cy + v);
            if (u > 0) out.plot(cx - u, cy + v);
            if (v > 0) out.plot(cx + u, cy - v);
            if (u > 0 && v > 0) out.plot(cx - u, cy - v);
        }
    }
}
