import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

public class MyCircle implements CircleRasterizer {
    @Override
    public void draw(int cx, int cy, int r, Pixels out) {
        if (r == 0) {
            out.plot(cx, cy);
            return;
        }
        int u = 0;
        int v = r;
        long d = 1L - r;
        while (u <= v) {
            // all four signs, also where u is 0
            for (int su = -1; su <= 1; su += 2)
                for (int sv = -1; sv <= 1; sv += 2) {
                    out.plot(cx + su * u, cy + sv * v);
                    if (u != v) out.plot(cx + sv * v, cy + su * u);
                }
            if (d < 0) d += 2L * u + 3;
            else {
                d += 2L * (u - v) + 5;
                v--;
            }
            u++;
        }
    }
}
