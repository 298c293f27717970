package rasterlab.engine.fill;

import java.util.ArrayDeque;
import java.util.List;
import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;
import rasterlab.engine.study.Mutant;

/** Regions filled with one mistake. */
final class FillMutants {
    private static final int[][] FOUR = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    private static final int[][] EIGHT = {
        {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}
    };

    private FillMutants() {}

    static List<Mutant<SeedFiller>> all() {
        return List.of(
                new Mutant<>(
                        "always-four-neighbours",
                        "diagonal-gap-8",
                        (picture, x, y, with, connectivity) -> fill(picture, x, y, with, FOUR)),
                new Mutant<>(
                        "always-eight-neighbours",
                        "diagonal-gap-4",
                        (picture, x, y, with, connectivity) -> fill(picture, x, y, with, EIGHT)),
                new Mutant<>(
                        "never-upwards",
                        "corridor-behind",
                        (picture, x, y, with, connectivity) ->
                                fill(picture, x, y, with, new int[][] {{1, 0}, {-1, 0}, {0, 1}})),
                new Mutant<>(
                        "same-colour-started",
                        "same-colour",
                        (picture, x, y, with, connectivity) ->
                                spread(picture, x, y, with, of(connectivity), false)),
                new Mutant<>(
                        "taken-up-unchecked",
                        "each-pixel-once",
                        (picture, x, y, with, connectivity) -> {
                            if (picture.read(x, y) != with)
                                spread(picture, x, y, with, of(connectivity), true);
                        }),
                new Mutant<>("holes-filled", "hole", FillMutants::withHoles),
                new Mutant<>(
                        "outline-recoloured",
                        "hole",
                        (picture, x, y, with, connectivity) -> {
                            fill(picture, x, y, with, of(connectivity));
                            for (int v = 0; v < picture.height(); v++)
                                for (int u = 0; u < picture.width(); u++)
                                    if (picture.read(u, v) == '#') picture.write(u, v, '+');
                        }),
                new Mutant<>("rim-left-out", "last-column-behind", FillMutants::withoutRim),
                new Mutant<>("any-colour-filled", "hole", FillMutants::anyColor),
                new Mutant<>("seed-left-out", "one-pixel", FillMutants::withoutSeed),
                new Mutant<>(
                        "seed-row-only",
                        "corridor-behind",
                        (picture, x, y, with, connectivity) ->
                                fill(picture, x, y, with, new int[][] {{1, 0}, {-1, 0}})));
    }

    private static int[][] of(int connectivity) {
        return connectivity == 4 ? FOUR : EIGHT;
    }

    private static void fill(PixelGrid picture, int x, int y, int with, int[][] neighbours) {
        if (picture.read(x, y) != with) spread(picture, x, y, with, neighbours, false);
    }

    /**
     * @param late whether a pixel is written when it is taken up again, without another look
     */
    private static void spread(
            PixelGrid picture, int x, int y, int with, int[][] neighbours, boolean late) {
        int old = picture.read(x, y);
        var waiting = new ArrayDeque<int[]>();
        waiting.add(new int[] {x, y});
        if (!late) picture.write(x, y, with);
        while (!waiting.isEmpty()) {
            int[] at = waiting.poll();
            if (late) picture.write(at[0], at[1], with);
            for (int[] step : neighbours) {
                int u = at[0] + step[0];
                int v = at[1] + step[1];
                if (u < 0 || u >= picture.width() || v < 0 || v >= picture.height()) continue;
                if (picture.read(u, v) != old) continue;
                if (!late) picture.write(u, v, with);
                waiting.add(new int[] {u, v});
            }
        }
    }

    /** Fills from the first to the last pixel of the region in each row. */
    private static void withHoles(PixelGrid picture, int x, int y, int with, int connectivity) {
        fill(picture, x, y, with, of(connectivity));
        for (int v = 0; v < picture.height(); v++) {
            int last = -1;
            for (int u = 0; u < picture.width(); u++) {
                if (picture.read(u, v) != with) continue;
                for (int k = last + 1; last >= 0 && k < u; k++) picture.write(k, v, with);
                last = u;
            }
        }
    }

    /** Never enters the first and the last row and column. */
    private static void withoutRim(PixelGrid picture, int x, int y, int with, int connectivity) {
        int old = picture.read(x, y);
        if (old == with) return;
        picture.write(x, y, with);
        var waiting = new ArrayDeque<int[]>();
        waiting.add(new int[] {x, y});
        while (!waiting.isEmpty()) {
            int[] at = waiting.poll();
            for (int[] step : of(connectivity)) {
                int u = at[0] + step[0];
                int v = at[1] + step[1];
                if (u < 1 || u >= picture.width() - 1 || v < 1 || v >= picture.height() - 1)
                    continue;
                if (picture.read(u, v) != old) continue;
                picture.write(u, v, with);
                waiting.add(new int[] {u, v});
            }
        }
    }

    /**
     * Goes on over every colour but the new one, as a fill up to an outline of that colour does.
     */
    private static void anyColor(PixelGrid picture, int x, int y, int with, int connectivity) {
        if (picture.read(x, y) == with) return;
        picture.write(x, y, with);
        var waiting = new ArrayDeque<int[]>();
        waiting.add(new int[] {x, y});
        while (!waiting.isEmpty()) {
            int[] at = waiting.poll();
            for (int[] step : of(connectivity)) {
                int u = at[0] + step[0];
                int v = at[1] + step[1];
                if (u < 0 || u >= picture.width() || v < 0 || v >= picture.height()) continue;
                if (picture.read(u, v) == with) continue;
                picture.write(u, v, with);
                waiting.add(new int[] {u, v});
            }
        }
    }

    private static void withoutSeed(PixelGrid picture, int x, int y, int with, int connectivity) {
        int old = picture.read(x, y);
        if (old == with) return;
        fill(new SeedKept(picture, x, y, old), x, y, with, of(connectivity));
    }

    /** A picture in which one pixel seems written and is not. */
    private static final class SeedKept implements PixelGrid {
        private final PixelGrid picture;
        private final int x;
        private final int y;
        private int seen;

        SeedKept(PixelGrid picture, int x, int y, int old) {
            this.picture = picture;
            this.x = x;
            this.y = y;
            seen = old;
        }

        @Override
        public int width() {
            return picture.width();
        }

        @Override
        public int height() {
            return picture.height();
        }

        @Override
        public int read(int u, int v) {
            return u == x && v == y ? seen : picture.read(u, v);
        }

        @Override
        public void write(int u, int v, int color) {
            if (u == x && v == y) seen = color;
            else picture.write(u, v, color);
        }
    }
}
