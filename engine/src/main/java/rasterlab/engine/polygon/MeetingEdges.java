package rasterlab.engine.polygon;

import java.util.Arrays;
import java.util.Optional;
import java.util.TreeSet;
import rasterlab.engine.geometry.Orientation;

/**
 * Finds two edges of a polygon that meet elsewhere than at the corner they share.
 *
 * <p>Edge i joins corner i to the next. A line sweeps over the corners by x (and by y among equal
 * x) and keeps the edges it crosses in order from below. Two edges that meet are neighbours in this
 * order before the line reaches their common point, so only neighbours are tested: O(n log n) for n
 * corners. All tests are exact.
 *
 * <p>Source: M. I. Shamos, D. Hoey, Geometric intersection problems, 17th Annual Symposium on
 * Foundations of Computer Science, 1976, pp. 208–215.
 */
public final class MeetingEdges {
    private final double[] x;
    private final double[] y;
    private final int[] from;
    private final int[] to;

    /** The edges at each corner. */
    private final int[][] at;

    private final TreeSet<Integer> crossed = new TreeSet<>(this::compare);
    private Optional<EdgePair> found = Optional.empty();

    private MeetingEdges(double[] x, double[] y, int[] from, int[] to, int[][] at) {
        this.x = x;
        this.y = y;
        this.from = from;
        this.to = to;
        this.at = at;
    }

    /**
     * Two edges by their numbers.
     *
     * @param one the smaller number
     */
    public record EdgePair(int one, int other) {}

    /**
     * The first pair that the sweep finds; none where the polygon is simple.
     *
     * <p>Corners in one place are a pair too: the edges that start there.
     *
     * @param x of at least 3 corners, finite, no two following ones in one place
     * @param y as many
     */
    public static Optional<EdgePair> of(double[] x, double[] y) {
        int n = x.length;
        int[] from = new int[n];
        int[] to = new int[n];
        int[][] at = new int[n][];
        for (int i = 0; i < n; i++) {
            from[i] = i;
            to[i] = (i + 1) % n;
            at[i] = new int[] {(i + n - 1) % n, i};
        }
        return new MeetingEdges(x, y, from, to, at).sweep();
    }

    /**
     * The first pair of any edges that meet: edge i joins corner from[i] to corner to[i].
     *
     * @param x of the corners, finite, no two in one place
     * @param y as many
     * @param from the corner where each edge begins
     * @param to where it ends, another one; no two edges join the same corners
     */
    public static Optional<EdgePair> of(double[] x, double[] y, int[] from, int[] to) {
        int[] count = new int[x.length];
        for (int e = 0; e < from.length; e++) {
            count[from[e]]++;
            count[to[e]]++;
        }
        int[][] at = new int[x.length][];
        for (int i = 0; i < x.length; i++) at[i] = new int[count[i]];
        for (int e = 0; e < from.length; e++) {
            at[from[e]][--count[from[e]]] = e;
            at[to[e]][--count[to[e]]] = e;
        }
        return new MeetingEdges(x, y, from, to, at).sweep();
    }

    private Optional<EdgePair> sweep() {
        int n = x.length;
        Integer[] order = new Integer[n];
        Arrays.setAll(order, i -> i);
        // comparingDouble would not do: for it −0 is less than 0.
        Arrays.sort(order, (i, j) -> before(i, j) ? -1 : before(j, i) ? 1 : 0);
        for (int i = 1; i < n; i++)
            if (!before(order[i - 1], order[i])) return Optional.of(pair(order[i - 1], order[i]));
        for (int i = 0; i < n && found.isEmpty(); i++) visit(order[i]);
        return found;
    }

    private void visit(int corner) {
        for (int edge : at[corner]) if (first(edge) != corner) remove(edge);
        for (int edge : at[corner]) if (first(edge) == corner) insert(edge);
    }

    private void insert(int edge) {
        Integer below = crossed.lower(edge);
        Integer above = crossed.higher(edge);
        if (below != null) test(below, edge);
        if (above != null) test(edge, above);
        crossed.add(edge);
    }

    private void remove(int edge) {
        Integer below = crossed.lower(edge);
        Integer above = crossed.higher(edge);
        crossed.remove(edge);
        if (below != null && above != null) test(below, above);
    }

    /** The end of an edge that the sweep meets first. */
    private int first(int edge) {
        return before(from[edge], to[edge]) ? from[edge] : to[edge];
    }

    private int last(int edge) {
        return before(from[edge], to[edge]) ? to[edge] : from[edge];
    }

    private boolean before(int one, int other) {
        return x[one] < x[other] || x[one] == x[other] && y[one] < y[other];
    }

    /** Order from below of two edges that the sweep line crosses. */
    private int compare(int one, int other) {
        if (one == other) return 0;
        if (before(first(other), first(one))) return -compare(other, one);
        int side = side(one, first(other));
        if (side == 0) side = side(one, last(other));
        return side == 0 ? Integer.compare(one, other) : -side;
    }

    /** 1 where a corner lies above an edge or its line, −1 below, 0 on it. */
    private int side(int edge, int corner) {
        int a = first(edge);
        int b = last(edge);
        return Orientation.of(x[a], y[a], x[b], y[b], x[corner], y[corner]);
    }

    private void test(int one, int other) {
        if (found.isPresent()) return;
        if (neighbours(one, other) ? overlap(one, other) : meet(one, other))
            found = Optional.of(pair(one, other));
    }

    private static EdgePair pair(int one, int other) {
        return new EdgePair(Math.min(one, other), Math.max(one, other));
    }

    private boolean neighbours(int one, int other) {
        return from[one] == from[other]
                || from[one] == to[other]
                || to[one] == from[other]
                || to[one] == to[other];
    }

    /** Whether two edges with a shared corner run back over each other. */
    private boolean overlap(int one, int other) {
        boolean sameLine = side(one, first(other)) == 0 && side(one, last(other)) == 0;
        return sameLine && (first(one) == first(other) || last(one) == last(other));
    }

    private boolean meet(int one, int other) {
        int first = side(one, first(other));
        int last = side(one, last(other));
        if (first == 0 && last == 0)
            return !before(last(one), first(other)) && !before(last(other), first(one));
        return first * last <= 0 && side(other, first(one)) * side(other, last(one)) <= 0;
    }
}
