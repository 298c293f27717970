import java.util.ArrayDeque;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

public class DownFill implements SeedFiller {
    private static final int[][] FOUR = {{1, 0}, {-1, 0}, {0, 1}};

    @Override
    public void fill(PixelGrid picture, int x, int y, int with, int connectivity) {
        int old = picture.read(x, y);
        if (old == with) return;
        var todo = new ArrayDeque<int[]>();
        todo.add(new int[] {x, y});
        while (!todo.isEmpty()) {
            int[] p = todo.pollLast();
            if (picture.read(p[0], p[1]) != old) continue;
            picture.write(p[0], p[1], with);
            for (int[] step : FOUR) {
                int u = p[0] + step[0];
                int v = p[1] + step[1];
                if (u >= 0 && u < picture.width() && v < picture.height()) todo.add(new int[] {u, v});
            }
        }
    }
}
