import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import rasterlab.contract.Triangulator;

/** Cuts ears, one after another, from the ring of the vertices that are left. */
public class Model implements Triangulator {
    private double[] x;
    private double[] y;

    @Override
    public int[] triangulate(double[] x, double[] y) {
        this.x = x;
        this.y = y;
        List<Integer> ring = ring();
        int[] triangles = new int[3 * (ring.size() - 2)];
        int count = 0;
        int at = 0;
        int failed = 0;
        while (ring.size() >= 3) {
            int n = ring.size();
            int before = ring.get((at + n - 1) % n);
            int tip = ring.get(at);
            int after = ring.get((at + 1) % n);
            if (n == 3 || ear(ring, before, tip, after)) {
                triangles[count++] = before;
                triangles[count++] = tip;
                triangles[count++] = after;
                ring.remove(at);
                if (ring.size() < 3) break;
                at = (at + ring.size() - 1) % ring.size();
                failed = 0;
            } else {
                if (++failed > n) throw new IllegalArgumentException("polygon is not simple");
                at = (at + 1) % n;
            }
        }
        return triangles;
    }

    /** The vertices counter-clockwise, each place once. */
    private List<Integer> ring() {
        List<Integer> ring = new ArrayList<>();
        double twice = 0;
        for (int i = 0; i < x.length; i++) {
            int j = i == 0 ? x.length - 1 : i - 1;
            if (x[i] == x[j] && y[i] == y[j]) continue;
            ring.add(i);
            twice += (x[j] - x[0]) * (y[i] - y[0]) - (x[i] - x[0]) * (y[j] - y[0]);
        }
        if (twice < 0) Collections.reverse(ring);
        return ring;
    }

    private boolean ear(List<Integer> ring, int a, int b, int c) {
        if (turn(a, b, c) <= 0) return false;
        for (int p : ring) {
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    }

    private double turn(int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }
}
