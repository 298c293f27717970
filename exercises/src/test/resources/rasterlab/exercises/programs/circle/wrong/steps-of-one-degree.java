import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements CircleRasterizer {

    public void draw(int cx, int cy, int r, Pixels out) {
        Set<String> s = new HashSet<>();
        for (int i = 0; i < 360; i++) {
            int x = (int) Math.round(cx + r * Math.cos(Math.toRadians(i))),
                    y = (int) Math.round(cy + r * Math.sin(Math.toRadians(i)));
            if (s.add(x + "," + y)) out.plot(x, y);
        }
    }
}
