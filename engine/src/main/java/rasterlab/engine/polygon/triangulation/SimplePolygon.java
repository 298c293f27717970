package rasterlab.engine.polygon.triangulation;

import java.util.TreeSet;
import java.util.stream.IntStream;

/**
 * Tells whether a polygon's edges meet only at the corner they share, by a sweep from left to
 * right.
 *
 * <p>Edge i joins corner i to the next. The sweep visits the corners in order and keeps the edges
 * that a vertical line there cuts, ordered from below. Two edges that meet are neighbours in that
 * order before the sweep reaches the place, so only neighbours are looked at: n·log n exact
 * orientations for n corners. An edge that starts on another, or goes back along it, has no place
 * in the order.
 *
 * <p>Source: M. I. Shamos, D. Hoey, Geometric intersection problems, 17th Symposium on Foundations
 * of Computer Science, 1976, pp. 208–215.
 */
final class SimplePolygon {
    private final Corners corners;
    private final TreeSet<Integer> cut = new TreeSet<>(this::belowFirst);

    SimplePolygon(Corners corners) {
        this.corners = corners;
    }

    /**
     * Passes if the polygon neither crosses nor touches itself.
     *
     * @throws IllegalArgumentException naming two edges that meet, by their first corners
     */
    void require() {
        int[] order =
                IntStream.range(0, corners.size())
                        .boxed()
                        .sorted(corners::compare)
                        .mapToInt(i -> i)
                        .toArray();
        for (int at = 0; at < order.length; at++) {
            if (at > 0 && corners.compare(order[at - 1], order[at]) == 0)
                throw meeting(order[at - 1], order[at]);
            visit(order[at]);
        }
    }

    private void visit(int corner) {
        int[] edges = {corners.before(corner), corner};
        for (int edge : edges)
            if (right(edge) == corner) {
                Integer below = cut.lower(edge);
                Integer above = cut.higher(edge);
                cut.remove(edge);
                if (below != null && above != null) requireApart(below, above);
            }
        for (int edge : edges)
            if (left(edge) == corner) {
                cut.add(edge);
                Integer below = cut.lower(edge);
                Integer above = cut.higher(edge);
                if (below != null) requireApart(below, edge);
                if (above != null) requireApart(edge, above);
            }
    }

    private int left(int edge) {
        int end = corners.after(edge);
        return corners.compare(edge, end) < 0 ? edge : end;
    }

    private int right(int edge) {
        int end = corners.after(edge);
        return corners.compare(edge, end) < 0 ? end : edge;
    }

    /** Order of two edges cut by one vertical line, from below. */
    private int belowFirst(int one, int other) {
        if (one == other) return 0;
        int starts = corners.compare(left(one), left(other));
        if (starts < 0) return -belowFirst(other, one);
        // one starts where other does or later: on which side of other?
        int side =
                starts == 0
                        ? corners.turn(left(other), right(other), right(one))
                        : corners.turn(left(other), right(other), left(one));
        if (side == 0) throw meeting(one, other);
        return side;
    }

    private void requireApart(int one, int other) {
        if (corners.after(one) == other || corners.after(other) == one) return;
        int p = one;
        int q = corners.after(one);
        int r = other;
        int s = corners.after(other);
        boolean acrossOther = corners.turn(r, s, p) * corners.turn(r, s, q) <= 0;
        boolean acrossOne = corners.turn(p, q, r) * corners.turn(p, q, s) <= 0;
        if (acrossOther && acrossOne && overlap(one, other)) throw meeting(one, other);
    }

    /** Whether the edges' extents overlap, which settles the case of four corners on one line. */
    private boolean overlap(int one, int other) {
        return corners.compare(left(one), right(other)) <= 0
                && corners.compare(left(other), right(one)) <= 0;
    }

    private IllegalArgumentException meeting(int one, int other) {
        int first = Math.min(corners.number[one], corners.number[other]);
        int second = Math.max(corners.number[one], corners.number[other]);
        return new IllegalArgumentException(
                "edges may meet only at the corner they share, but those from corners "
                        + first
                        + " and "
                        + second
                        + " meet elsewhere");
    }
}
