import java.util.TreeSet;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;

public class EllipseByRoots implements EllipseRasterizer {
    @Override
    public void draw(int cx, int cy, int width, int height, Pixels out) {
        var sent = new TreeSet<String>();
        // one formula for both, with the roles exchanged
        for (int i = 0; i <= height; i++) four(cx, cy, i, other(i, height, width), sent, out);
        for (int i = 0; i <= width; i++) four(cx, cy, other(i, width, height), i, sent, out);
    }

    private static int other(int i, double along, double across) {
        return along == 0 ? (int) across : (int) Math.round(across * Math.sqrt(1 - i * i / along / along));
    }

    private static void four(int cx, int cy, int u, int v, TreeSet<String> sent, Pixels out) {
        for (int x : new int[] {u, -u})
            for (int y : new int[] {v, -v}) if (sent.add(x + " " + y)) out.plot(cx + x, cy + y);
    }
}
