import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements CircleRasterizer {

    public void draw(int cx, int cy, int r, Pixels out) {
        Set<String> s = new HashSet<>();
        int x = 0, y = r, d = 3 - 2 * r;
        while (x <= y) {
            eight(cx, cy, x, y, out, s);
            x++;
            if (d > 0) {
                y--;
                d += 4 * (x - y) + 10;
            } else d += 4 * x + 6;
        }
    }

    void eight(int cx, int cy, int x, int y, Pixels out, Set<String> s) {
        int[][] p = {{x, y}, {-x, y}, {x, -y}, {-x, -y}, {y, x}, {-y, x}, {y, -x}, {-y, -x}};
        for (int[] q : p) if (s.add(q[0] + "," + q[1])) out.plot(cx + q[0], cy + q[1]);
    }
}
