import java.util.LinkedList;
import java.util.Queue;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

public class QueueFill implements SeedFiller {
    @Override
    public void fill(PixelGrid picture, int x, int y, int with, int connectivity) {
        int old = picture.read(x, y);
        if (old == with) return;
        Queue<int[]> queue = new LinkedList<>();
        queue.add(new int[] {x, y});
        while (!queue.isEmpty()) {
            int[] p = queue.remove();
            picture.write(p[0], p[1], with);
            for (int dy = -1; dy <= 1; dy++)
                for (int dx = -1; dx <= 1; dx++) {
                    if (dx == 0 && dy == 0 || connectivity == 4 && dx * dy != 0) continue;
                    int u = p[0] + dx;
                    int v = p[1] + dy;
                    boolean inside = u >= 0 && v >= 0 && u < picture.width() && v < picture.height();
                    if (inside && picture.read(u, v) == old) queue.add(new int[] {u, v});
                }
        }
    }
}
