import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements SeedFiller {

    public void fill(PixelGrid p, int x, int y, int with, int connectivity) {
        int old = p.read(x, y);
        if (old == with) return;
        ArrayDeque<int[]> queue = new ArrayDeque<>();
        p.write(x, y, with);
        queue.add(new int[] {x, y});
        while (!queue.isEmpty()) {
            int[] q = queue.poll();
            for (int dy = -1; dy <= 1; dy++)
                for (int dx = -1; dx <= 1; dx++) {
                    if (dx == 0 && dy == 0) continue;
                    if (connectivity == 4 && dx != 0 && dy != 0) continue;
                    int nx = q[0] + dx, ny = q[1] + dy;
                    if (nx < 0 || ny < 0 || nx >= p.width() || ny >= p.height()) continue;
                    if (p.read(nx, ny) == with) continue;
                    p.write(nx, ny, with);
                    queue.add(new int[] {nx, ny});
                }
        }
    }
}
