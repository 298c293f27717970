package rasterlab.engine.fill;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.study.Slip;

/** Regions filled from a mistaken seed, in too few directions or not as far as they go. */
final class FillSlips {
    private static final int[][] NEXT = {
        {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}
    };

    private FillSlips() {}

    static List<Slip<SeedFiller>> of(SeedFiller right) {
        return List.of(
                Slip.of(
                        "seed-x-y-swapped",
                        (picture, x, y, with, connectivity) ->
                                right.fill(picture, y, x, with, connectivity)),
                Slip.of("never-to-the-right", never(1, 0)),
                Slip.of("never-to-the-left", never(-1, 0)),
                Slip.of("never-downwards", never(0, 1)),
                Slip.of("neighbours-of-the-seed-only", FillSlips::once),
                Slip.of("whole-colour-replaced", FillSlips::everywhere),
                Slip.of(
                        "diagonals-only",
                        (picture, x, y, with, connectivity) ->
                                reach(picture, x, y, with, List.of(4, 5, 6, 7))),
                new Slip<>(
                        "one-diagonal-missing",
                        IntStream.range(4, 8).mapToObj(FillSlips::withoutDiagonal).toList()),
                Slip.of("border-of-picture-left-out", within(right, 0, 1), within(right, 1, 1)));
    }

    private static SeedFiller never(int dx, int dy) {
        return (picture, x, y, with, connectivity) -> {
            List<Integer> ways = new ArrayList<>();
            for (int i = 0; i < connectivity; i++)
                if (NEXT[i][0] != dx || NEXT[i][1] != dy) ways.add(i);
            reach(picture, x, y, with, ways);
        };
    }

    private static SeedFiller withoutDiagonal(int way) {
        return (picture, x, y, with, connectivity) -> {
            List<Integer> ways = new ArrayList<>();
            for (int i = 0; i < connectivity; i++) if (i != way) ways.add(i);
            reach(picture, x, y, with, ways);
        };
    }

    private static void reach(PixelGrid picture, int x, int y, int with, List<Integer> ways) {
        int old = picture.read(x, y);
        if (old == with) return;
        var waiting = new ArrayDeque<int[]>();
        picture.write(x, y, with);
        waiting.push(new int[] {x, y});
        while (!waiting.isEmpty()) {
            int[] at = waiting.pop();
            for (int way : ways) {
                int u = at[0] + NEXT[way][0];
                int v = at[1] + NEXT[way][1];
                if (!isIn(picture, u, v) || picture.read(u, v) != old) continue;
                picture.write(u, v, with);
                waiting.push(new int[] {u, v});
            }
        }
    }

    private static boolean isIn(PixelGrid picture, int x, int y) {
        return x >= 0 && y >= 0 && x < picture.width() && y < picture.height();
    }

    private static void once(PixelGrid picture, int x, int y, int with, int connectivity) {
        int old = picture.read(x, y);
        if (old == with) return;
        picture.write(x, y, with);
        for (int i = 0; i < connectivity; i++) {
            int u = x + NEXT[i][0];
            int v = y + NEXT[i][1];
            if (isIn(picture, u, v) && picture.read(u, v) == old) picture.write(u, v, with);
        }
    }

    private static void everywhere(PixelGrid picture, int x, int y, int with, int connectivity) {
        int old = picture.read(x, y);
        if (old == with) return;
        for (int v = 0; v < picture.height(); v++)
            for (int u = 0; u < picture.width(); u++)
                if (picture.read(u, v) == old) picture.write(u, v, with);
    }

    /** Fills a picture that is smaller at its first and last sides. */
    private static SeedFiller within(SeedFiller right, int first, int last) {
        return (picture, x, y, with, connectivity) -> {
            if (x < first || y < first) return;
            if (x >= picture.width() - last || y >= picture.height() - last) return;
            right.fill(new Part(picture, first, last), x - first, y - first, with, connectivity);
        };
    }

    private record Part(PixelGrid whole, int first, int last) implements PixelGrid {
        @Override
        public int width() {
            return whole.width() - first - last;
        }

        @Override
        public int height() {
            return whole.height() - first - last;
        }

        @Override
        public int read(int x, int y) {
            return whole.read(x + first, y + first);
        }

        @Override
        public void write(int x, int y, int color) {
            whole.write(x + first, y + first, color);
        }
    }
}
