import java.util.ArrayList;
import rasterlab.contract.Triangulator;

public class Ears implements Triangulator {
    @Override
    public int[] triangulate(double[] x, double[] y) {
        double area = 0;
        var ring = new ArrayList<Integer>();
        for (int i = 0; i < x.length; i++) {
            int j = (i + 1) % x.length;
            area += x[i] * y[j] - x[j] * y[i];
            if (x[i] != x[j] || y[i] != y[j]) ring.add(j);
        }
        double sign = Math.signum(area);
        var triangles = new ArrayList<Integer>();
        for (int k = 0; ring.size() > 2; k++) {
            int n = ring.size();
            int a = ring.get(k % n), b = ring.get((k + 1) % n), c = ring.get((k + 2) % n);
            if (sign * turn(x, y, a, b, c) <= 0) continue;
            boolean ear = true;
            for (int p : ring)
                if (p != a && p != b && p != c)
                    ear &=
                            sign * turn(x, y, a, b, p) < 0
                                    || sign * turn(x, y, b, c, p) < 0
                                    || sign * turn(x, y, c, a, p) < 0;
            if (!ear) continue;
            triangles.add(a);
            triangles.add(b);
            triangles.add(c);
            ring.remove((k + 1) % n);
        }
        return triangles.stream().mapToInt(i -> i).toArray();
    }

    private static double turn(double[] x, double[] y, int a, int b, int c) {
        return (x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a]);
    }
}
