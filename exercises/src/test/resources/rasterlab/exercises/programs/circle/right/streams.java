import rasterlab.contract.*;

import java.util.stream.*;

public class MyMethod implements CircleRasterizer {

    record P(int x, int y) {}

    public void draw(int cx, int cy, int r, Pixels out) {
        Stream.iterate(0, u -> u + 1)
                .takeWhile(u -> u <= row(r, u))
                .flatMap(
                        u -> {
                            int v = row(r, u);
                            return Stream.of(new P(u, v), new P(v, u));
                        })
                .flatMap(p -> Stream.of(p, new P(-p.x, p.y), new P(p.x, -p.y), new P(-p.x, -p.y)))
                .distinct()
                .forEach(p -> out.plot(cx + p.x, cy + p.y));
    }

    static int row(int r, int u) {
        return u > r ? -1 : (int) Math.round(Math.sqrt((double) r * r - (double) u * u));
    }
}
