package rasterlab.engine.clip.polygon;

import java.util.Arrays;
import java.util.Comparator;
import java.util.TreeSet;
import rasterlab.engine.geometry.Orientation;

/**
 * Accepts polygons whose edges meet only at shared corners, and turns them counter-clockwise.
 *
 * <p>A line sweeps over the corners by x (and by y among equal x) and keeps the edges it crosses in
 * order from below. Two edges that meet are neighbours in this order before the line reaches their
 * common point, so only neighbours are tested: O(n log n) for n corners. All tests are exact.
 *
 * <p>Source: M. I. Shamos and D. Hoey, Geometric intersection problems, 17th Annual Symposium on
 * Foundations of Computer Science, 1976, pp. 208–215.
 */
final class SimpleSubject {
    private final Ring ring;
    private final TreeSet<Integer> crossed;

    private SimpleSubject(Ring ring) {
        this.ring = ring;
        crossed = new TreeSet<>(this::compare);
    }

    /**
     * @throws IllegalArgumentException if edges meet elsewhere than at shared corners; names them
     */
    static Ring of(double[] corners) {
        Ring ring = Ring.of("subject", corners);
        new SimpleSubject(ring).sweep();
        return ring.turn(ring.lowest()) < 0 ? ring.reversed() : ring;
    }

    private void sweep() {
        int n = ring.size();
        Integer[] order = new Integer[n];
        Arrays.setAll(order, i -> i);
        Arrays.sort(
                order, Comparator.<Integer>comparingDouble(ring::x).thenComparingDouble(ring::y));
        for (int i = 1; i < n; i++) requireDifferent(order[i - 1], order[i]);
        for (int corner : order) {
            int before = (corner + n - 1) % n;
            if (first(before) != corner) remove(before);
            if (first(corner) != corner) remove(corner);
            if (first(before) == corner) insert(before);
            if (first(corner) == corner) insert(corner);
        }
    }

    private void requireDifferent(int one, int other) {
        if (ring.x(one) == ring.x(other) && ring.y(one) == ring.y(other))
            throw new IllegalArgumentException(
                    "subject must be simple, but corner " + place(one) + " is there twice");
    }

    private void insert(int edge) {
        Integer below = crossed.lower(edge);
        Integer above = crossed.higher(edge);
        if (below != null) requireApart(below, edge);
        if (above != null) requireApart(edge, above);
        crossed.add(edge);
    }

    private void remove(int edge) {
        Integer below = crossed.lower(edge);
        Integer above = crossed.higher(edge);
        crossed.remove(edge);
        if (below != null && above != null) requireApart(below, above);
    }

    /** The end of an edge that the sweep meets first. */
    private int first(int edge) {
        int next = (edge + 1) % ring.size();
        return before(edge, next) ? edge : next;
    }

    private int last(int edge) {
        int next = (edge + 1) % ring.size();
        return before(edge, next) ? next : edge;
    }

    private boolean before(int one, int other) {
        return ring.x(one) < ring.x(other)
                || ring.x(one) == ring.x(other) && ring.y(one) < ring.y(other);
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
        return Orientation.of(
                ring.x(a), ring.y(a), ring.x(b), ring.y(b), ring.x(corner), ring.y(corner));
    }

    private void requireApart(int one, int other) {
        if (neighbours(one, other) ? overlap(one, other) : meet(one, other))
            throw new IllegalArgumentException(
                    "subject must be simple, but the edges from corners "
                            + place(Math.min(one, other))
                            + " and "
                            + place(Math.max(one, other))
                            + " meet");
    }

    private boolean neighbours(int one, int other) {
        int apart = Math.abs(one - other);
        return apart == 1 || apart == ring.size() - 1;
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

    private String place(int corner) {
        return "(" + ring.x(corner) + ", " + ring.y(corner) + ")";
    }
}
