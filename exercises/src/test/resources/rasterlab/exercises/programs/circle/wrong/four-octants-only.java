import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements CircleRasterizer {

    public void draw(int cx, int cy, int r, Pixels out) {
        Set<List<Integer>> seen = new LinkedHashSet<>();
        int v = r;
        for (int u = 0; u <= v; u++) {
            while ((long) u * u + (long) v * v - v >= (long) r * r && v > 0) v--;
            if (u > v) break;
            int[][] p = {{u, v}, {v, u}, {-u, v}, {-v, u}, {u, -v}, {v, -u}, {-u, -v}, {-v, -u}};
            for (int[] q : new int[][] {p[0], p[2], p[4], p[6]}) seen.add(List.of(q[0], q[1]));
        }
        for (List<Integer> q : seen) out.plot(cx + q.get(0), cy + q.get(1));
    }
}
