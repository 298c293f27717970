package rasterlab.engine.fill;

import java.util.ArrayDeque;
import rasterlab.contract.Pixels;

/** The reference: breadth first over a grid of booleans, every pixel looked at from each side. */
final class ExactSeedFill {
    private final boolean[][] open;
    private final int reach;

    /** A seed outside the picture reaches nothing, and neither does a fill with the old colour. */
    private final boolean changes;

    private final FillTask task;

    ExactSeedFill(FillTask task) {
        this.task = task;
        int[][] colors =
                task.rows().stream().map(r -> r.codePoints().toArray()).toArray(int[][]::new);
        boolean inside = task.y() >= 0 && task.y() < colors.length;
        inside = inside && task.x() >= 0 && task.x() < colors[task.y()].length;
        changes = inside && colors[task.y()][task.x()] != task.with();
        reach = task.connectivity() == 8 ? 2 : 1;
        open = new boolean[colors.length][];
        for (int y = 0; y < colors.length; y++) {
            open[y] = new boolean[colors[y].length];
            for (int x = 0; x < open[y].length && changes; x++)
                open[y][x] = colors[y][x] == colors[task.y()][task.x()];
        }
    }

    /** Sends each pixel whose colour changes once, the seed first, nearer ones before farther. */
    void fill(Pixels out) {
        var queue = new ArrayDeque<int[]>();
        if (changes) reach(task.x(), task.y(), queue);
        while (!queue.isEmpty()) {
            int[] pixel = queue.remove();
            out.plot(pixel[0], pixel[1]);
            for (int y = Math.max(0, pixel[1] - 1); y <= pixel[1] + 1 && y < open.length; y++)
                for (int x = Math.max(0, pixel[0] - 1); x <= pixel[0] + 1; x++)
                    if (Math.abs(x - pixel[0]) + Math.abs(y - pixel[1]) <= reach)
                        reach(x, y, queue);
        }
    }

    private void reach(int x, int y, ArrayDeque<int[]> queue) {
        if (x >= open[y].length || !open[y][x]) return;
        open[y][x] = false;
        queue.add(new int[] {x, y});
    }
}
