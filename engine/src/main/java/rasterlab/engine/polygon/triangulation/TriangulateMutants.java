package rasterlab.engine.polygon.triangulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.Triangulator;
import rasterlab.engine.study.Mutant;

/** Polygons cut into triangles with one mistake. */
final class TriangulateMutants {
    private static final Triangulator RIGHT = new EarClipping();

    private TriangulateMutants() {}

    static List<Mutant<Triangulator>> all() {
        return List.of(
                new Mutant<>("fan-from-the-first", "fan-leaves", (x, y) -> fan(x.length)),
                new Mutant<>("ear-unchecked", "corner-in-the-ear", TriangulateMutants::anyLeftTurn),
                new Mutant<>("winds-as-polygon", "clockwise", TriangulateMutants::asThePolygon),
                new Mutant<>(
                        "absolute-epsilon",
                        "small-units",
                        (x, y) -> {
                            if (Math.abs(area(x, y)) < 1e-6)
                                throw new IllegalArgumentException("polygon has no area");
                            return RIGHT.triangulate(x, y);
                        }),
                new Mutant<>(
                        "straight-corners-skipped",
                        "corners-on-a-side",
                        TriangulateMutants::withoutStraight),
                new Mutant<>(
                        "triangle-for-repeated",
                        "repeated-corners",
                        TriangulateMutants::withRepeated),
                new Mutant<>(
                        "triangle-gives-none",
                        "one-triangle",
                        (x, y) -> x.length == 3 ? new int[0] : RIGHT.triangulate(x, y)));
    }

    private static int[] fan(int corners) {
        var all = new int[3 * (corners - 2)];
        for (int t = 0; t < corners - 2; t++) {
            all[3 * t + 1] = t + 1;
            all[3 * t + 2] = t + 2;
        }
        return all;
    }

    private static int[] anyLeftTurn(double[] x, double[] y) {
        var ring = new ArrayList<Integer>();
        for (int i = 0; i < x.length; i++) ring.add(i);
        var all = new ArrayList<Integer>();
        while (ring.size() > 2) {
            int n = ring.size();
            int k = shortest(x, y, ring);
            all.addAll(List.of(ring.get(k), ring.get((k + 1) % n), ring.get((k + 2) % n)));
            ring.remove((k + 1) % n);
        }
        return all.stream().mapToInt(Integer::intValue).toArray();
    }

    /** The place in the ring of the left turn with the shortest diagonal. */
    private static int shortest(double[] x, double[] y, List<Integer> ring) {
        int n = ring.size();
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < n; k++) {
            int from = ring.get(k);
            int to = ring.get((k + 2) % n);
            if (turn(x, y, from, ring.get((k + 1) % n), to) <= 0) continue;
            double diagonal = Math.hypot(x[to] - x[from], y[to] - y[from]);
            if (diagonal < least) best = k;
            least = Math.min(least, diagonal);
        }
        if (best < 0) throw new IllegalArgumentException("polygon has no left turn");
        return best;
    }

    private static int[] asThePolygon(double[] x, double[] y) {
        int[] all = RIGHT.triangulate(x, y);
        if (area(x, y) >= 0) return all;
        for (int t = 0; t < all.length; t += 3) {
            int second = all[t + 1];
            all[t + 1] = all[t + 2];
            all[t + 2] = second;
        }
        return all;
    }

    private static int[] withoutStraight(double[] x, double[] y) {
        var kept = new ArrayList<Integer>();
        for (int i = 0; i < x.length; i++)
            if (turn(x, y, (i + x.length - 1) % x.length, i, (i + 1) % x.length) != 0) kept.add(i);
        double[] keptX = kept.stream().mapToDouble(i -> x[i]).toArray();
        double[] keptY = kept.stream().mapToDouble(i -> y[i]).toArray();
        return Arrays.stream(RIGHT.triangulate(keptX, keptY)).map(kept::get).toArray();
    }

    private static int[] withRepeated(double[] x, double[] y) {
        int[] all = RIGHT.triangulate(x, y);
        for (int i = 1; i < x.length; i++)
            if (x[i] == x[i - 1] && y[i] == y[i - 1]) {
                all = Arrays.copyOf(all, all.length + 3);
                all[all.length - 3] = i - 1;
                all[all.length - 2] = i;
                all[all.length - 1] = (i + 1) % x.length;
            }
        return all;
    }

    private static double turn(double[] x, double[] y, int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }

    private static double area(double[] x, double[] y) {
        double twice = 0;
        for (int i = 0; i < x.length; i++) {
            int j = (i + 1) % x.length;
            twice += x[i] * y[j] - x[j] * y[i];
        }
        return twice;
    }
}
