import rasterlab.contract.Triangulator;

/** Cuts ears recursively, the last vertex first; its triangles begin at their last vertex. */
public class LastEar implements Triangulator {
    @Override
    public int[] triangulate(double[] x, double[] y) {
        int[] ring = new int[0];
        double area = 0;
        for (int i = 0; i < x.length; i++) {
            int before = (i + x.length - 1) % x.length;
            area += (x[before] - x[0]) * (y[i] - y[0]) - (x[i] - x[0]) * (y[before] - y[0]);
            if (x[i] != x[before] || y[i] != y[before]) ring = joined(ring, new int[] {i});
        }
        if (area < 0)
            for (int i = 0; i < ring.length / 2; i++) {
                int kept = ring[i];
                ring[i] = ring[ring.length - 1 - i];
                ring[ring.length - 1 - i] = kept;
            }
        return cut(x, y, ring);
    }

    private int[] cut(double[] x, double[] y, int[] ring) {
        int n = ring.length;
        if (n < 3) return new int[0];
        for (int k = n - 1; k >= 0; k--) {
            int a = ring[(k + n - 1) % n];
            int b = ring[k];
            int c = ring[(k + 1) % n];
            if (!isEar(x, y, ring, a, b, c)) continue;
            int[] rest = new int[n - 1];
            for (int i = 0, to = 0; i < n; i++) if (i != k) rest[to++] = ring[i];
            return joined(new int[] {c, a, b}, cut(x, y, rest));
        }
        throw new IllegalStateException("no ear");
    }

    private static boolean isEar(double[] x, double[] y, int[] ring, int a, int b, int c) {
        if (turn(x, y, a, b, c) <= 0) return false;
        for (int p : ring) {
            if (p == a || p == b || p == c) continue;
            if (turn(x, y, a, b, p) >= 0 && turn(x, y, b, c, p) >= 0 && turn(x, y, c, a, p) >= 0)
                return false;
        }
        return true;
    }

    private static double turn(double[] x, double[] y, int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }

    private static int[] joined(int[] first, int[] second) {
        int[] all = new int[first.length + second.length];
        System.arraycopy(first, 0, all, 0, first.length);
        System.arraycopy(second, 0, all, first.length, second.length);
        return all;
    }
}
