import rasterlab.contract.*;

import java.math.*;
import java.util.*;

public class MyMethod implements Triangulator {

    public int[] triangulate(double[] x, double[] y) {
        List<Integer> r = new ArrayList<>();
        int n = x.length;
        for (int i = 0; i < n; i++) {
            int p = (i + n - 1) % n;
            if (x[i] != x[p] || y[i] != y[p]) r.add(i);
        }
        BigDecimal s = BigDecimal.ZERO;
        for (int i = 0; i < r.size(); i++)
            s = s.add(cross(x, y, r.get(0), r.get(i), r.get((i + 1) % r.size())));
        if (s.signum() < 0) Collections.reverse(r);
        List<Integer> o = new ArrayList<>();
        cut(x, y, r, o);
        return o.stream().mapToInt(Integer::intValue).toArray();
    }

    static BigDecimal cross(double[] x, double[] y, int a, int b, int c) {
        BigDecimal ax = new BigDecimal(x[a]), ay = new BigDecimal(y[a]);
        return new BigDecimal(x[b])
                .subtract(ax)
                .multiply(new BigDecimal(y[c]).subtract(ay))
                .subtract(
                        new BigDecimal(y[b])
                                .subtract(ay)
                                .multiply(new BigDecimal(x[c]).subtract(ax)));
    }

    static int t(double[] x, double[] y, int a, int b, int c) {
        return cross(x, y, a, b, c).signum();
    }

    static void cut(double[] x, double[] y, List<Integer> r, List<Integer> o) {
        int m = r.size();
        if (m < 3) return;
        for (int i = m - 1; i >= 0; i--) {
            int a = r.get((i + m - 1) % m), b = r.get(i), c = r.get((i + 1) % m);
            if (t(x, y, a, b, c) <= 0) continue;
            boolean ok = true;
            for (int p : r)
                if (p != a
                        && p != b
                        && p != c
                        && t(x, y, a, b, p) >= 0
                        && t(x, y, b, c, p) >= 0
                        && t(x, y, c, a, p) >= 0) {
                    ok = false;
                    break;
                }
            if (!ok) continue;
            o.add(b);
            o.add(c);
            o.add(a);
            List<Integer> q = new ArrayList<>(r);
            q.remove(i);
            cut(x, y, q, o);
            return;
        }
    }
}
