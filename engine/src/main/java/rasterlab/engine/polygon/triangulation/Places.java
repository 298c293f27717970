package rasterlab.engine.polygon.triangulation;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** The places of a polygon's corners, numbered in the order they first come. */
final class Places {
    private final int[] of;
    private final int[][] corners;

    private Places(int[] of, int count) {
        this.of = of;
        int[] sizes = new int[count];
        for (int place : of) sizes[place]++;
        corners = new int[count][];
        for (int place = 0; place < count; place++) corners[place] = new int[sizes[place]];
        for (int i = of.length - 1; i >= 0; i--) corners[of[i]][--sizes[of[i]]] = i;
    }

    static Places of(Corners corners) {
        record CornerPoint(double x, double y) {}
        Map<CornerPoint, Integer> numbers = new HashMap<>();
        int[] of = new int[corners.size()];
        for (int i = 0; i < of.length; i++) {
            // Adding 0 makes a 0 of −0, which is the same place.
            var place = new CornerPoint(corners.x[i] + 0.0, corners.y[i] + 0.0);
            Integer known = numbers.putIfAbsent(place, numbers.size());
            of[i] = known == null ? numbers.size() - 1 : known;
        }
        return new Places(of, numbers.size());
    }

    /** Whether several corners are in one place. */
    boolean shared() {
        return corners.length < of.length;
    }

    int count() {
        return corners.length;
    }

    int of(int corner) {
        return of[corner];
    }

    boolean same(int one, int other) {
        return of[one] == of[other];
    }

    /** The corners in the place of one, in their order. */
    int[] corners(int corner) {
        return corners[of[corner]];
    }

    /** One corner for each place. */
    int[] firsts() {
        return Arrays.stream(corners).mapToInt(at -> at[0]).toArray();
    }
}
