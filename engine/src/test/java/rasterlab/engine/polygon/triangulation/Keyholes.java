package rasterlab.engine.polygon.triangulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import rasterlab.engine.polygon.Points;

/** Squares of side 4 on a grid of 10, cut out of a large square and joined by bridges. */
final class Keyholes {
    private static final int SIDE = 4;
    private static final int GRID = 10;

    private Keyholes() {}

    static int area(int holes) {
        return size(holes) * size(holes) - holes * SIDE * SIDE;
    }

    private static int size(int holes) {
        return GRID * holes;
    }

    /**
     * The holes lie one behind the other along a rising line, so that a bridge from the large
     * square's first corner, or from the hole before, crosses no hole.
     */
    static Points of(int holes, Random random) {
        int size = size(holes);
        List<int[]> way = new ArrayList<>(List.of(new int[] {0, 0}));
        way.addAll(rest(0, holes, random));
        way.add(new int[] {0, 0});
        way.add(new int[] {size, 0});
        way.add(new int[] {size, size});
        way.add(new int[] {0, size});
        return Points.of(way.stream().flatMapToInt(Arrays::stream).asDoubleStream().toArray());
    }

    /** Round a hole, on the way there and back round those behind it. */
    private static List<int[]> rest(int hole, int holes, Random random) {
        if (hole == holes) return List.of();
        int low = GRID * hole + 2 + random.nextInt(3);
        int high = low + SIDE;
        List<int[]> way = new ArrayList<>();
        way.add(new int[] {low, low});
        way.add(new int[] {low, high});
        way.add(new int[] {high, high});
        List<int[]> behind = rest(hole + 1, holes, random);
        if (!behind.isEmpty()) {
            way.addAll(behind);
            way.add(new int[] {high, high});
        }
        way.add(new int[] {high, low});
        way.add(new int[] {low, low});
        return way;
    }
}
