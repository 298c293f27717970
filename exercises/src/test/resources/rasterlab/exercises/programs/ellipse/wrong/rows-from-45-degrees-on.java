import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements EllipseRasterizer {

    public void draw(int cx, int cy, int a, int b, Pixels out) {
        Set<String> s = new HashSet<>();
        for (int u = 0; u <= a; u++) {
            int v =
                    a == 0
                            ? b
                            : (int)
                                    Math.round(
                                            b * Math.sqrt(1 - (double) u * u / ((double) a * a)));
            if (u <= v) put(s, u, v, cx, cy, out);
        }
        for (int v = 0; v <= b; v++) {
            int u =
                    b == 0
                            ? a
                            : (int)
                                    Math.round(
                                            a * Math.sqrt(1 - (double) v * v / ((double) b * b)));
            if (v <= u) put(s, u, v, cx, cy, out);
        }
    }

    static void put(Set<String> s, int u, int v, int cx, int cy, Pixels out) {
        int[][] p = {{u, v}, {-u, v}, {u, -v}, {-u, -v}};
        for (int[] q : p) if (s.add(q[0] + " " + q[1])) out.plot(cx + q[0], cy + q[1]);
    }
}
