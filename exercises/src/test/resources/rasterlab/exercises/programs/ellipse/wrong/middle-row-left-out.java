import java.util.HashSet;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;

public class TwoRegions implements EllipseRasterizer {
    @Override
    public void draw(int cx, int cy, int a, int b, Pixels out) {
        if (b == 0) {
            for (int x = -a; x <= a; x++) out.plot(cx + x, cy);
            return;
        }
        var sent = new HashSet<Long>();
        for (int u = 0; u <= a; u++) {
            int v = near(u, a, b);
            if (v > 0) mirror(cx, cy, u, v, sent, out);
        }
        int v = b;
        while (v > 0) {
            mirror(cx, cy, near(v, b, a), v, sent, out);
            v--;
        }
    }

    private static int near(int i, double along, double across) {
        return along == 0 ? (int) across : (int) Math.round(across * Math.sqrt(1 - i * i / along / along));
    }

    private static void mirror(int cx, int cy, int u, int v, HashSet<Long> sent, Pixels out) {
        if (!sent.add((long) u << 32 | v)) return;
        out.plot(cx + u, cy + v);
        out.plot(cx + u, cy - v);
        if (u == 0) return;
        out.plot(cx - u, cy + v);
        out.plot(cx - u, cy - v);
    }
}
