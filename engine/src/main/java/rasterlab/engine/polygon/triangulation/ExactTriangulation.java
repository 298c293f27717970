package rasterlab.engine.polygon.triangulation;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rasterlab.engine.polygon.Points;

/**
 * A polygon in decimal numbers of any length: its area, whether it can be cut, and one way to cut
 * it.
 *
 * <p>It can where it is simple, or where edges that are gone along both ways join outsides and
 * holes to one way. Then corners in one place stand for each other.
 *
 * <p>Slow and plain: every edge is held against every other, every corner against every triangle.
 * Shares no code with the methods it judges.
 */
public final class ExactTriangulation {
    private final BigDecimal[] x;
    private final BigDecimal[] y;
    private final List<Integer> ring = new ArrayList<>();
    private final Map<List<BigDecimal>, Integer> firstAt = new HashMap<>();

    /** Whether each edge is gone along the other way too. */
    private final boolean[] bridge;

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
        for (int i : ring) firstAt.putIfAbsent(place(i), i);
        if (doubledArea().signum() < 0) Collections.reverse(ring);
        bridge = new boolean[ring.size()];
        findBridges();
    }

    private void findBridges() {
        if (firstAt.size() == ring.size()) return;
        for (int e = 0; e < bridge.length; e++)
            for (int f = 0; f < bridge.length; f++)
                bridge[e] |= same(from(e), to(f)) && same(to(e), from(f));
    }

    /** The corners without repetitions, counter-clockwise. */
    public List<Integer> ring() {
        return List.copyOf(ring);
    }

    /** The number that stands for corner i: that of the first in its place. */
    int standIn(int i) {
        return firstAt.getOrDefault(place(i), i);
    }

    private List<BigDecimal> place(int i) {
        return List.of(x[i], y[i]);
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

    /** Whether edges meet only at the corner they share, or in bridges, and there is area. */
    boolean simple() {
        int n = ring.size();
        if (n < 3 || doubledArea().signum() == 0) return false;
        for (int e = 0; e < n; e++)
            for (int f = e + 1; f < n; f++) if (!mayMeet(e, f)) return false;
        if (firstAt.size() == n) return true;
        for (int e = 0; e < n; e++) if (!bridge[e] && !(alone(e) && windsOnce(e))) return false;
        return true;
    }

    private int from(int edge) {
        return ring.get(edge);
    }

    private int to(int edge) {
        return ring.get((edge + 1) % ring.size());
    }

    private boolean mayMeet(int e, int f) {
        int p = from(e);
        int q = to(e);
        int r = from(f);
        int s = to(f);
        if (same(p, s) && same(q, r)) return true;
        boolean inOrder = f == e + 1 || (f + 1) % ring.size() == e;
        boolean starts = same(p, r) && !on(p, q, s) && !on(r, s, q);
        boolean ends = same(q, s) && !on(p, q, r) && !on(r, s, p);
        boolean follows = same(q, r) && !on(p, q, s) && !on(r, s, p);
        boolean leads = same(s, p) && !on(r, s, q) && !on(p, q, r);
        if (inOrder) return follows || leads;
        if (starts || leads) return endsBridge(p);
        if (ends || follows) return endsBridge(q);
        return !meet(p, q, r, s);
    }

    private boolean endsBridge(int corner) {
        for (int f = 0; f < ring.size(); f++)
            if ((same(corner, from(f)) || same(corner, to(f))) && bridge[f]) return true;
        return false;
    }

    /** Whether no other edge but bridges begins where an edge begins. */
    private boolean alone(int edge) {
        for (int f = 0; f < ring.size(); f++)
            if (f != edge && same(from(f), from(edge)) && !bridge[f]) return false;
        return true;
    }

    /**
     * Whether the way goes round what is left of an edge once, and not round what is right of it.
     */
    private boolean windsOnce(int edge) {
        boolean upright = y[from(edge)].compareTo(y[to(edge)]) != 0;
        BigDecimal[] along = upright ? y : x;
        BigDecimal[] away = upright ? x : y;
        BigDecimal middle = along[from(edge)].add(along[to(edge)]);
        int rounds = 0;
        for (int f = 0; f < ring.size(); f++) {
            if (f == edge || bridge[f]) continue;
            int begins = along[from(f)].add(along[from(f)]).compareTo(middle);
            int ends = along[to(f)].add(along[to(f)]).compareTo(middle);
            boolean up = begins <= 0 && ends > 0;
            boolean down = ends <= 0 && begins > 0;
            if ((up || down) && isBeyond(f, edge, away, along)) rounds += up ? 1 : -1;
        }
        boolean rises = along[to(edge)].compareTo(along[from(edge)]) > 0;
        // The ray goes right from an upright edge, and up from a level one, across which the way
        // round is seen in a mirror.
        return upright ? rounds == (rises ? 0 : 1) : -rounds == (rises ? 1 : 0);
    }

    /** Whether edge f crosses the ray from the middle of another towards larger coordinates. */
    private boolean isBeyond(int f, int edge, BigDecimal[] away, BigDecimal[] along) {
        BigDecimal two = BigDecimal.valueOf(2);
        BigDecimal middleAway = away[from(edge)].add(away[to(edge)]);
        BigDecimal middleAlong = along[from(edge)].add(along[to(edge)]);
        BigDecimal rise = along[to(f)].subtract(along[from(f)]);
        BigDecimal run = away[to(f)].subtract(away[from(f)]);
        BigDecimal behind =
                two.multiply(away[from(f)])
                        .subtract(middleAway)
                        .multiply(rise)
                        .add(middleAlong.subtract(two.multiply(along[from(f)])).multiply(run));
        return behind.signum() * rise.signum() > 0;
    }

    /** One triangulation; empty where the polygon cannot be cut. */
    Triangles cut() {
        if (!simple()) return new Triangles();
        var left = new ArrayList<>(ring);
        var triples = new ArrayList<Integer>();
        takeSpikes(left);
        while (left.size() >= 3) {
            int ear = anEar(left);
            if (ear < 0) return new Triangles();
            triples.add(left.get((ear + left.size() - 1) % left.size()));
            triples.add(left.get(ear));
            triples.add(left.get((ear + 1) % left.size()));
            left.remove(ear);
            takeSpikes(left);
        }
        return new Triangles(triples.stream().mapToInt(i -> i).toArray());
    }

    /** Where the way goes back, the corner there and one of its neighbours go. */
    private void takeSpikes(List<Integer> left) {
        for (int k = 0; k < left.size() && left.size() > 2; k++) {
            int n = left.size();
            if (!same(left.get((k + n - 1) % n), left.get((k + 1) % n))) continue;
            Integer tip = left.get(k);
            Integer after = left.get((k + 1) % n);
            left.remove(tip);
            left.remove(after);
            k = -1;
        }
    }

    /** The place in the list of a corner that can be cut off; −1 where there is none. */
    private int anEar(List<Integer> left) {
        int n = left.size();
        for (int k = 0; k < n; k++) {
            int a = left.get((k + n - 1) % n);
            int b = left.get(k);
            int c = left.get((k + 1) % n);
            if (doubledArea(a, b, c).signum() > 0
                    && left.stream().noneMatch(p -> in(a, b, c, p))
                    && !isEntered(left, k, a, c)) return k;
        }
        return -1;
    }

    /** Whether an edge at another corner in the place of corner k runs between a and c. */
    private boolean isEntered(List<Integer> left, int k, int a, int c) {
        int n = left.size();
        int b = left.get(k);
        for (int m = 0; m < n; m++) {
            if (m == k || !same(left.get(m), b)) continue;
            for (int q : List.of(left.get((m + 1) % n), left.get((m + n - 1) % n)))
                if (doubledArea(b, c, q).signum() > 0 && doubledArea(b, a, q).signum() < 0)
                    return true;
        }
        return false;
    }

    private boolean in(int a, int b, int c, int p) {
        return !same(p, a)
                && !same(p, b)
                && !same(p, c)
                && doubledArea(a, b, p).signum() >= 0
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
