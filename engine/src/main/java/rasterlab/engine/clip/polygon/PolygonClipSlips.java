package rasterlab.engine.clip.polygon;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import rasterlab.contract.PolygonClipper;
import rasterlab.engine.study.Slip;

/** Polygons clipped side by side with one step mistaken. */
final class PolygonClipSlips {
    private PolygonClipSlips() {}

    static List<Slip<PolygonClipper>> of(PolygonClipper right) {
        return List.of(
                Slip.of("first-side-only", clipping(1, true, (d, e) -> e / (e - d))),
                Slip.of(
                        "cut-from-the-other-end",
                        clipping(Integer.MAX_VALUE, true, (d, e) -> d / (d - e))),
                Slip.of("cut-in-the-middle", clipping(Integer.MAX_VALUE, true, (d, e) -> 0.5)),
                Slip.of("vertices-only", clipping(Integer.MAX_VALUE, true, null)),
                Slip.of("outside-kept", clipping(Integer.MAX_VALUE, false, (d, e) -> e / (e - d))),
                Slip.of(
                        "polygon-not-cut",
                        (window, subject, out) ->
                                right.clip(window, subject, piece -> out.polygon(subject))));
    }

    private record Point(double x, double y) {}

    private interface Share {
        /** The share of the first point in the cut, by how far both are inside. */
        double of(double lastInside, double nextInside);
    }

    /**
     * Sutherland and Hodgman's way.
     *
     * @param sides that cut
     * @param inner whether the points inside stay, not those outside
     * @param share of the cut; null where there is none
     */
    private static PolygonClipper clipping(int sides, boolean inner, Share share) {
        return (window, subject, out) -> {
            List<Point> box = turned(window);
            List<Point> left = turned(subject);
            for (int i = 0; i < Math.min(sides, box.size()) && !left.isEmpty(); i++)
                left = cut(left, box.get(i), box.get((i + 1) % box.size()), inner, share);
            if (left.size() < 3 || area(left) <= 1e-12 * area(box)) return;
            var corners = new double[2 * left.size()];
            for (int i = 0; i < left.size(); i++) {
                corners[2 * i] = left.get(i).x();
                corners[2 * i + 1] = left.get(i).y();
            }
            out.polygon(corners);
        };
    }

    private static List<Point> cut(
            List<Point> polygon, Point a, Point b, boolean inner, Share share) {
        List<Point> left = new ArrayList<>();
        Point last = polygon.get(polygon.size() - 1);
        for (Point next : polygon) {
            double d = side(a, b, last);
            double e = side(a, b, next);
            if (d * e < 0 && share != null) {
                double part = share.of(d, e);
                left.add(
                        new Point(
                                part * last.x() + (1 - part) * next.x(),
                                part * last.y() + (1 - part) * next.y()));
            }
            if (inner ? e >= 0 : e <= 0) left.add(next);
            last = next;
        }
        return left;
    }

    private static double side(Point a, Point b, Point p) {
        return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    }

    /** The corners counter-clockwise, each once where it is repeated. */
    private static List<Point> turned(double[] corners) {
        List<Point> all = new ArrayList<>();
        for (int i = 0; i < corners.length; i += 2) {
            var one = new Point(corners[i], corners[i + 1]);
            if (all.isEmpty() || !all.get(all.size() - 1).equals(one)) all.add(one);
        }
        if (area(all) < 0) Collections.reverse(all);
        return all;
    }

    private static double area(List<Point> all) {
        double twice = 0;
        for (int i = 0; i < all.size(); i++) {
            Point a = all.get(i);
            Point b = all.get((i + 1) % all.size());
            twice += a.x() * b.y() - b.x() * a.y();
        }
        return twice / 2;
    }
}
