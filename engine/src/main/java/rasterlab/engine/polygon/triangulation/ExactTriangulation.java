package rasterlab.engine.polygon.triangulation;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import rasterlab.engine.polygon.Points;

/**
 * A polygon in decimal numbers of any length: its area, whether it is simple, and one way to cut
 * it.
 *
 * <p>Slow and plain: every edge is held against every other, every corner against every triangle.
 * Shares no code with the methods it judges.
 */
public final class ExactTriangulation {
    private final BigDecimal[] x;
    private final BigDecimal[] y;
    private final List<Integer> ring = new ArrayList<>();

    public ExactTriangulation(Points corners) {
        int n = corners.size();
        x = new BigDecimal[n];
        y = new BigDecimal[n];
        for (int i = 0; i < n; i++) {
            x[i] = new BigDecimal(corners.x(i));
            y[i] = new BigDecimal(corners.y(i));
        }
        for (int i = 0; i < n; i++)
            if (ring.isEmpty() || !same(i, ring.get(ring.size() - 1))) ring.add(i);
        while (ring.size() > 1 && same(ring.get(0), ring.get(ring.size() - 1)))
            ring.remove(ring.size() - 1);
        if (doubledArea().signum() < 0) Collections.reverse(ring);
    }

    /** The corners without repetitions, counter-clockwise. */
    public List<Integer> ring() {
        return List.copyOf(ring);
    }

    /**
     * The number that stands for corner i: that of the first of its equal neighbours in the list.
     */
    int standIn(int i) {
        if (ring.contains(i)) return i;
        for (int k = i - 1; k >= 0; k--)
            if (!same(k, i)) break;
            else if (ring.contains(k)) return k;
        return ring.contains(0) && same(0, i) ? 0 : i;
    }

    /** Twice the area, negative where the ring goes clockwise. */
    public BigDecimal doubledArea() {
        BigDecimal area = BigDecimal.ZERO;
        for (int k = 0; k < ring.size(); k++) {
            int i = ring.get(k);
            int j = ring.get((k + 1) % ring.size());
            area = area.add(x[i].multiply(y[j])).subtract(x[j].multiply(y[i]));
        }
        return area;
    }

    /** Twice the area of the triangle i, j, k; negative where it goes clockwise. */
    public BigDecimal doubledArea(int i, int j, int k) {
        BigDecimal left = x[j].subtract(x[i]).multiply(y[k].subtract(y[i]));
        return left.subtract(y[j].subtract(y[i]).multiply(x[k].subtract(x[i])));
    }

    /** Whether edges meet only at the corner they share, and there is area. */
    boolean simple() {
        int n = ring.size();
        if (n < 3 || doubledArea().signum() == 0) return false;
        for (int e = 0; e < n; e++)
            for (int f = e + 1; f < n; f++) {
                int p = ring.get(e);
                int q = ring.get((e + 1) % n);
                int r = ring.get(f);
                int s = ring.get((f + 1) % n);
                boolean follows = f == e + 1;
                boolean leads = (f + 1) % n == e;
                if (follows && on(p, q, s) || leads && on(r, s, q)) return false;
                if (follows && on(r, s, p) || leads && on(p, q, r)) return false;
                if (!follows && !leads && meet(p, q, r, s)) return false;
            }
        return true;
    }

    /** One triangulation; empty where the polygon is not simple. */
    Triangles cut() {
        if (!simple()) return new Triangles();
        var left = new ArrayList<>(ring);
        var triples = new ArrayList<Integer>();
        while (left.size() >= 3) {
            int ear = anEar(left);
            triples.add(left.get((ear + left.size() - 1) % left.size()));
            triples.add(left.get(ear));
            triples.add(left.get((ear + 1) % left.size()));
            left.remove(ear);
        }
        return new Triangles(triples.stream().mapToInt(i -> i).toArray());
    }

    private int anEar(List<Integer> left) {
        int n = left.size();
        for (int k = 0; k < n; k++) {
            int a = left.get((k + n - 1) % n);
            int b = left.get(k);
            int c = left.get((k + 1) % n);
            if (doubledArea(a, b, c).signum() > 0
                    && left.stream().noneMatch(p -> p != a && p != b && p != c && in(a, b, c, p)))
                return k;
        }
        throw new AssertionError("a simple polygon without an ear");
    }

    private boolean in(int a, int b, int c, int p) {
        return doubledArea(a, b, p).signum() >= 0
                && doubledArea(b, c, p).signum() >= 0
                && doubledArea(c, a, p).signum() >= 0;
    }

    private boolean same(int i, int j) {
        return x[i].compareTo(x[j]) == 0 && y[i].compareTo(y[j]) == 0;
    }

    /** Whether corner k lies on the segment from i to j. */
    private boolean on(int i, int j, int k) {
        return doubledArea(i, j, k).signum() == 0
                && x[k].compareTo(x[i].min(x[j])) >= 0
                && x[k].compareTo(x[i].max(x[j])) <= 0
                && y[k].compareTo(y[i].min(y[j])) >= 0
                && y[k].compareTo(y[i].max(y[j])) <= 0;
    }

    private boolean meet(int p, int q, int r, int s) {
        if (on(p, q, r) || on(p, q, s) || on(r, s, p) || on(r, s, q)) return true;
        return doubledArea(p, q, r).signum() * doubledArea(p, q, s).signum() < 0
                && doubledArea(r, s, p).signum() * doubledArea(r, s, q).signum() < 0;
    }
}
