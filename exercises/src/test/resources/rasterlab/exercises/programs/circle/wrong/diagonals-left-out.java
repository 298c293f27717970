import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

public class MyCircle implements CircleRasterizer {
    @Override
    public void draw(int cx, int cy, int r, Pixels out) {
        if (r == 0) out.plot(cx, cy);
        long v = r;
        for (long u = 0; u < v; u++) {
            while (u * u + v * v - v >= (long) r * r) v--;
            if (u >= v) break;
            int[][] mirrored = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
            for (int[] sign : mirrored) {
                if (u == 0 && sign[0] < 0) continue;
                out.plot((int) (cx + sign[0] * u), (int) (cy + sign[1] * v));
                out.plot((int) (cx + sign[1] * v), (int) (cy + sign[0] * u));
            }
        }
    }
}
