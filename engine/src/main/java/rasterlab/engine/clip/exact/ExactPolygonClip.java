package rasterlab.engine.clip.exact;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;

/**
 * The right pieces of a polygon in a convex window, in fractions: one side's line after the other
 * cuts each piece into those on its left.
 *
 * <p>The runs of a ring strictly left of the line begin and end on it. With the ring
 * counter-clockwise, each run's end is joined along the line to the nearest beginning further on.
 * Shares no code with the methods it judges. Time grows with the square of the corners.
 */
public final class ExactPolygonClip {
    private ExactPolygonClip() {}

    private record Point(Ratio x, Ratio y) {
        static Point of(double[] xy, int corner) {
            return new Point(Ratio.of(xy[2 * corner]), Ratio.of(xy[2 * corner + 1]));
        }

        /** Twice the area of this, b, c: above 0 where they turn left. */
        Ratio turn(Point b, Point c) {
            return b.x.minus(x).times(c.y.minus(y)).minus(b.y.minus(y).times(c.x.minus(x)));
        }

        Point towards(Point other, Ratio share) {
            return new Point(
                    x.plus(other.x.minus(x).times(share)), y.plus(other.y.minus(y).times(share)));
        }
    }

    /** A part of a ring strictly left of the line, with its ends on the line. */
    private record Run(List<Point> points, Ratio begins, Ratio ends, boolean hollowEnd) {}

    /**
     * The pieces, counter-clockwise, each coordinate the double nearest to the exact one; none that
     * fewer than three corners are left of by that.
     *
     * @param window corners of a convex polygon with an area
     * @param subject corners of a simple polygon
     * @return nothing where {@code window} and {@code subject} are not as they should be
     */
    public static List<double[]> pieces(double[] window, double[] subject) {
        if (!ProperInput.is(window, subject)) return List.of();
        List<Point> sides = counterClockwise(window);
        List<List<Point>> rings = List.of(counterClockwise(subject));
        for (int i = 0; i < sides.size(); i++) {
            var cut = new ArrayList<List<Point>>();
            for (var ring : rings)
                cut.addAll(leftOf(sides.get(i), sides.get((i + 1) % sides.size()), ring));
            rings = cut;
        }
        return rings.stream()
                .map(ExactPolygonClip::rounded)
                .filter(piece -> piece.length >= 6)
                .toList();
    }

    private static List<Point> counterClockwise(double[] xy) {
        var ring = new ArrayList<Point>();
        for (int i = 0; i < xy.length / 2; i++) {
            Point corner = Point.of(xy, i);
            if (ring.isEmpty() || !ring.get(ring.size() - 1).equals(corner)) ring.add(corner);
        }
        if (ring.get(0).equals(ring.get(ring.size() - 1))) ring.remove(ring.size() - 1);
        Ratio area = Ratio.ZERO;
        for (int i = 1; i + 1 < ring.size(); i++)
            area = area.plus(ring.get(0).turn(ring.get(i), ring.get(i + 1)));
        if (area.signum() < 0) Collections.reverse(ring);
        return ring;
    }

    private static List<List<Point>> leftOf(Point a, Point b, List<Point> ring) {
        List<Ratio> sides = ring.stream().map(point -> a.turn(b, point)).toList();
        if (sides.stream().allMatch(side -> side.signum() <= 0)) return List.of();
        if (sides.stream().allMatch(side -> side.signum() >= 0)) return List.of(ring);
        return joined(runs(a, b, ring, sides));
    }

    private static List<Run> runs(Point a, Point b, List<Point> ring, List<Ratio> sides) {
        int n = ring.size();
        int start = 0;
        while (sides.get(start).signum() > 0) start++;
        var runs = new ArrayList<Run>();
        var points = new ArrayList<Point>();
        for (int k = 0; k < n; k++) {
            int i = (start + k) % n;
            int j = (i + 1) % n;
            boolean from = sides.get(i).signum() > 0;
            boolean to = sides.get(j).signum() > 0;
            if (from != to)
                points.add(crossing(ring.get(i), sides.get(i), ring.get(j), sides.get(j)));
            if (to) points.add(ring.get(j));
            if (from && !to) {
                boolean hollow =
                        sides.get(j).signum() == 0
                                && ring.get(i).turn(ring.get(j), ring.get((j + 1) % n)).signum()
                                        < 0;
                runs.add(
                        new Run(
                                List.copyOf(points),
                                along(a, b, points.get(0)),
                                along(a, b, points.get(points.size() - 1)),
                                hollow));
                points.clear();
            }
        }
        return runs;
    }

    private static Point crossing(Point p, Ratio d, Point q, Ratio e) {
        return p.towards(q, d.by(d.minus(e)));
    }

    private static Ratio along(Point a, Point b, Point point) {
        return point.x()
                .minus(a.x())
                .times(b.x().minus(a.x()))
                .plus(point.y().minus(a.y()).times(b.y().minus(a.y())));
    }

    private static List<List<Point>> joined(List<Run> runs) {
        var open = new ArrayList<>(runs);
        open.sort(Comparator.comparing(Run::begins));
        var rings = new ArrayList<List<Point>>();
        while (!open.isEmpty()) {
            Run first = open.remove(0);
            var ring = new ArrayList<>(first.points());
            Run run = first;
            for (Run next = following(run, first, open); next != first; ) {
                open.remove(next);
                ring.addAll(next.points());
                run = next;
                next = following(run, first, open);
            }
            rings.add(ring);
        }
        return rings;
    }

    private static Run following(Run run, Run first, List<Run> open) {
        Run nearest = reaches(run, first) ? first : null;
        for (Run other : open)
            if (reaches(run, other)
                    && (nearest == null || other.begins().compareTo(nearest.begins()) < 0))
                nearest = other;
        if (nearest == null) throw new AssertionError("a run has no continuation");
        return nearest;
    }

    private static boolean reaches(Run run, Run other) {
        int order = other.begins().compareTo(run.ends());
        return run.hollowEnd() ? order > 0 : order >= 0;
    }

    /** The nearest doubles, without corners that are the same as the one before them. */
    private static double[] rounded(List<Point> ring) {
        var xy = new double[2 * ring.size()];
        int size = 0;
        for (Point corner : ring) {
            double x = corner.x().toDouble();
            double y = corner.y().toDouble();
            if (size > 0 && xy[size - 2] == x && xy[size - 1] == y) continue;
            xy[size++] = x;
            xy[size++] = y;
        }
        while (size > 2 && xy[0] == xy[size - 2] && xy[1] == xy[size - 1]) size -= 2;
        return Arrays.copyOf(xy, size);
    }
}
