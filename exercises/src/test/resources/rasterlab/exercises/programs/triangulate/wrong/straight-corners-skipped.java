import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Triangulator;

public class EarCut implements Triangulator {
    @Override
    public int[] triangulate(double[] x, double[] y) {
        int n = x.length;
        double area = 0;
        for (int i = 0; i < n; i++) area += x[i] * y[(i + 1) % n] - x[(i + 1) % n] * y[i];
        List<Integer> ring = new ArrayList<>();
        for (int i = 0; i < n; i++)
            if (turn(x, y, (i + n - 1) % n, i, (i + 1) % n) != 0) ring.add(area > 0 ? ring.size() : 0, i);
        List<Integer> out = new ArrayList<>();
        while (ring.size() > 2) {
            int cut = ear(x, y, ring);
            int m = ring.size();
            out.addAll(List.of(ring.get((cut + m - 1) % m), ring.get(cut), ring.get((cut + 1) % m)));
            ring.remove(cut);
        }
        return out.stream().mapToInt(Integer::intValue).toArray();
    }

    private static int ear(double[] x, double[] y, List<Integer> ring) {
        int m = ring.size();
        for (int k = 0; k < m; k++) {
            int a = ring.get((k + m - 1) % m), b = ring.get(k), c = ring.get((k + 1) % m);
            if (turn(x, y, a, b, c) <= 0) continue;
            boolean free =
                    ring.stream()
                            .filter(p -> p != a && p != b && p != c)
                            .noneMatch(
                                    p ->
                                            turn(x, y, a, b, p) >= 0
                                                    && turn(x, y, b, c, p) >= 0
                                                    && turn(x, y, c, a, p) >= 0);
            if (free) return k;
        }
        throw new IllegalStateException("no ear");
    }

    private static double turn(double[] x, double[] y, int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }
}
