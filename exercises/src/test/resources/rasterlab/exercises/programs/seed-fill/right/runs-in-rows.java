import java.util.ArrayDeque;
import java.util.Deque;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

public class RunFill implements SeedFiller {
    private record Place(int x, int y) {}

    @Override
    public void fill(PixelGrid g, int x, int y, int with, int connectivity) {
        int old = g.read(x, y);
        if (old == with) return;
        int reach = connectivity == 8 ? 1 : 0;
        Deque<Place> seeds = new ArrayDeque<>();
        seeds.add(new Place(x, y));
        while (!seeds.isEmpty()) {
            Place s = seeds.removeFirst();
            if (g.read(s.x, s.y) != old) continue;
            int from = s.x;
            int to = s.x;
            while (from > 0 && g.read(from - 1, s.y) == old) from--;
            while (to + 1 < g.width() && g.read(to + 1, s.y) == old) to++;
            for (int u = from; u <= to; u++) g.write(u, s.y, with);
            for (int v = s.y - 1; v <= s.y + 1; v += 2) {
                if (v < 0 || v >= g.height()) continue;
                for (int u = Math.max(0, from - reach); u <= Math.min(g.width() - 1, to + reach); u++)
                    if (g.read(u, v) == old) seeds.add(new Place(u, v));
            }
        }
    }
}
