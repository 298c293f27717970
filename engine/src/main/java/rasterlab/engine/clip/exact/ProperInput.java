package rasterlab.engine.clip.exact;

import java.math.BigInteger;
import java.util.ArrayList;

/**
 * Whether there is a right answer at all, found out by looking at all pairs of edges, without
 * rounding; for the exact reference.
 */
public final class ProperInput {
    private ProperInput() {}

    /** Whether the window is convex with an area and the subject is simple. */
    public static boolean is(double[] window, double[] subject) {
        if (!finite(window) || !finite(subject)) return false;
        BigInteger[][] around = distinct(window);
        return simple(around) && convex(around) && simple(distinct(subject));
    }

    private static boolean finite(double[] numbers) {
        for (double number : numbers) if (!Double.isFinite(number)) return false;
        return numbers.length % 2 == 0;
    }

    /** Corners in whole numbers, all coordinates times one power of two; equal neighbours once. */
    private static BigInteger[][] distinct(double[] xy) {
        BigInteger under = BigInteger.ONE;
        for (double coordinate : xy) under = under.max(Ratio.of(coordinate).under());
        var ring = new ArrayList<BigInteger[]>();
        for (int i = 0; i < xy.length; i += 2) {
            BigInteger[] corner = {times(under, xy[i]), times(under, xy[i + 1])};
            if (ring.isEmpty() || !same(ring.get(ring.size() - 1), corner)) ring.add(corner);
        }
        while (ring.size() > 1 && same(ring.get(0), ring.get(ring.size() - 1)))
            ring.remove(ring.size() - 1);
        return ring.toArray(new BigInteger[0][]);
    }

    private static BigInteger times(BigInteger under, double coordinate) {
        Ratio ratio = Ratio.of(coordinate);
        return ratio.over().multiply(under.divide(ratio.under()));
    }

    private static boolean same(BigInteger[] a, BigInteger[] b) {
        return a[0].equals(b[0]) && a[1].equals(b[1]);
    }

    private static boolean convex(BigInteger[][] ring) {
        int left = 0;
        int right = 0;
        for (int i = 0; i < ring.length; i++) {
            int turn = turn(ring[i], ring[(i + 1) % ring.length], ring[(i + 2) % ring.length]);
            if (turn > 0) left++;
            if (turn < 0) right++;
        }
        return left + right >= 3 && left * right == 0;
    }

    private static boolean simple(BigInteger[][] ring) {
        int n = ring.length;
        if (n < 3) return false;
        for (int i = 0; i < n; i++)
            for (int j = i + 1; j < n; j++) if (!apart(ring, i, j)) return false;
        return true;
    }

    private static boolean apart(BigInteger[][] ring, int i, int j) {
        int n = ring.length;
        BigInteger[] a = ring[i];
        BigInteger[] b = ring[(i + 1) % n];
        BigInteger[] c = ring[j];
        BigInteger[] d = ring[(j + 1) % n];
        if (j == i + 1) return !on(a, b, d) && !on(c, d, a);
        if (i == 0 && j == n - 1) return !on(c, d, b) && !on(a, b, c);
        if (on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b)) return false;
        return turn(a, b, c) * turn(a, b, d) >= 0 || turn(c, d, a) * turn(c, d, b) >= 0;
    }

    /** Whether p is a point of the edge a→b. */
    private static boolean on(BigInteger[] a, BigInteger[] b, BigInteger[] p) {
        return between(a[0], b[0], p[0]) && between(a[1], b[1], p[1]) && turn(a, b, p) == 0;
    }

    private static boolean between(BigInteger a, BigInteger b, BigInteger p) {
        return a.compareTo(p) * b.compareTo(p) <= 0;
    }

    private static int turn(BigInteger[] a, BigInteger[] b, BigInteger[] c) {
        BigInteger left = b[0].subtract(a[0]).multiply(c[1].subtract(a[1]));
        return left.compareTo(b[1].subtract(a[1]).multiply(c[0].subtract(a[0])));
    }
}
