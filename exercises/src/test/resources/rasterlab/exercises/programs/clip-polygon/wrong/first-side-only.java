import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import rasterlab.contract.PolygonClipper;
import rasterlab.contract.PolygonSink;

public class Lists implements PolygonClipper {
    record P(double x, double y) {}

    @Override
    public void clip(double[] window, double[] subject, PolygonSink out) {
        List<P> sides = turned(window);
        List<P> left = cut(sides, 0, turned(subject));
        if (left.size() < 3 || area(left) <= 1e-12 * area(sides)) return;
        out.polygon(left.stream().flatMap(p -> java.util.stream.Stream.of(p.x, p.y)).mapToDouble(v -> v).toArray());
    }

    private List<P> turned(double[] xy) {
        List<P> list = new ArrayList<>();
        for (int i = 0; i < xy.length; i += 2) {
            P p = new P(xy[i], xy[i + 1]);
            if (list.isEmpty() || !list.get(list.size() - 1).equals(p)) list.add(p);
        }
        if (area(list) < 0) Collections.reverse(list);
        return list;
    }

    private double area(List<P> list) {
        double sum = 0;
        for (int i = 0; i < list.size(); i++) {
            P a = list.get(i);
            P b = list.get((i + 1) % list.size());
            sum += (a.x - b.x) * (a.y + b.y);
        }
        return sum / 2;
    }

    private List<P> cut(List<P> window, int side, List<P> polygon) {
        if (side == 1 || polygon.isEmpty()) return polygon;
        P a = window.get(side);
        P b = window.get((side + 1) % window.size());
        List<P> left = new ArrayList<>();
        P last = polygon.get(polygon.size() - 1);
        for (P p : polygon) {
            double d = d(a, b, last);
            double e = d(a, b, p);
            if (d * e < 0) left.add(new P((last.x * e - p.x * d) / (e - d), (last.y * e - p.y * d) / (e - d)));
            if (e >= 0) left.add(p);
            last = p;
        }
        return cut(window, side + 1, left);
    }

    private double d(P a, P b, P p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    }
}
