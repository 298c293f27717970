import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements EllipseRasterizer {

    public void draw(int cx, int cy, int a, int b, Pixels out) {
        Set<String> s = new HashSet<>();
        for (int u = 0; u <= a; u++)
            put(
                    s,
                    u,
                    a == 0 ? b : (int) (b * Math.sqrt(1 - (double) u * u / ((double) a * a))),
                    cx,
                    cy,
                    out);
        for (int v = 0; v <= b; v++)
            put(
                    s,
                    b == 0 ? a : (int) (a * Math.sqrt(1 - (double) v * v / ((double) b * b))),
                    v,
                    cx,
                    cy,
                    out);
    }

    static void put(Set<String> s, int u, int v, int cx, int cy, Pixels out) {
        int[][] p = {{u, v}, {-u, v}, {u, -v}, {-u, -v}};
        for (int[] q : p) if (s.add(q[0] + " " + q[1])) out.plot(cx + q[0], cy + q[1]);
    }
}
