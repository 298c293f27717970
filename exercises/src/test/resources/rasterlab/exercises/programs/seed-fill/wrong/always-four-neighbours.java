import java.util.ArrayDeque;
import java.util.Deque;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

public class MyFill implements SeedFiller {
    @Override
    public void fill(PixelGrid picture, int x, int y, int with, int connectivity) {
        int old = picture.read(x, y);
        if (old == with) return;
        Deque<int[]> stack = new ArrayDeque<>();
        stack.push(new int[] {x, y});
        while (!stack.isEmpty()) {
            int[] p = stack.pop();
            if (p[0] < 0 || p[1] < 0 || p[0] >= picture.width() || p[1] >= picture.height()) continue;
            if (picture.read(p[0], p[1]) != old) continue;
            picture.write(p[0], p[1], with);
            stack.push(new int[] {p[0] + 1, p[1]});
            stack.push(new int[] {p[0] - 1, p[1]});
            stack.push(new int[] {p[0], p[1] + 1});
            stack.push(new int[] {p[0], p[1] - 1});
        }
    }
}
