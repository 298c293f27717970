package rasterlab.exercises.drawing;

import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * A stroke of a picture, in parts: those that other strokes cover and those that none does. All in
 * pixels.
 *
 * @param covered the parts along which another stroke runs
 * @param open all other parts
 */
record StrokeParts(List<Line2D> covered, List<Line2D> open) {
    /** Shorter parts are left out, in pixels. */
    private static final double SHORTEST = 0.5;

    private record Interval(double start, double end) {}

    /**
     * Covers a stroke with others.
     *
     * @param slack the most by which a stroke that covers may be beside it, in pixels
     */
    static StrokeParts of(Line2D stroke, List<Line2D> others, double slack) {
        double length = stroke.getP1().distance(stroke.getP2());
        if (length < SHORTEST) return dot(stroke, others, slack);
        var covered = new ArrayList<Interval>();
        for (Line2D other : others) {
            Interval part = alongside(stroke, other, slack);
            if (part.start < part.end) covered.add(part);
        }
        covered.sort(Comparator.comparingDouble(Interval::start));
        var merged = new ArrayList<Line2D>();
        var open = new ArrayList<Line2D>();
        double reached = 0;
        for (Interval part : covered) {
            if ((part.start - reached) * length >= SHORTEST)
                open.add(part(stroke, reached, part.start));
            if (part.end <= reached) continue;
            merged.add(part(stroke, Math.max(reached, part.start), part.end));
            reached = part.end;
        }
        if ((1 - reached) * length >= SHORTEST) open.add(part(stroke, reached, 1));
        return new StrokeParts(merged, open);
    }

    /** Covers a stroke that is no longer than a dot. */
    private static StrokeParts dot(Line2D stroke, List<Line2D> others, double slack) {
        boolean met = others.stream().anyMatch(other -> other.ptSegDist(stroke.getP1()) <= slack);
        return met
                ? new StrokeParts(List.of(stroke), List.of())
                : new StrokeParts(List.of(), List.of(stroke));
    }

    /** The part of a stroke that another runs beside; start = end for none. */
    private static Interval alongside(Line2D stroke, Line2D other, double slack) {
        double one = along(stroke, other.getP1());
        double two = along(stroke, other.getP2());
        double start = Math.max(0, Math.min(one, two));
        double end = Math.min(1, Math.max(one, two));
        boolean beside =
                start < end
                        && other.ptSegDist(at(stroke, start)) <= slack
                        && other.ptSegDist(at(stroke, end)) <= slack;
        return beside ? new Interval(start, end) : new Interval(0, 0);
    }

    /** Where the foot of a point lies: 0 at the stroke's beginning, 1 at its end. */
    private static double along(Line2D stroke, Point2D point) {
        double dx = stroke.getX2() - stroke.getX1();
        double dy = stroke.getY2() - stroke.getY1();
        return ((point.getX() - stroke.getX1()) * dx + (point.getY() - stroke.getY1()) * dy)
                / (dx * dx + dy * dy);
    }

    private static Point2D at(Line2D stroke, double share) {
        return new Point2D.Double(
                stroke.getX1() + share * (stroke.getX2() - stroke.getX1()),
                stroke.getY1() + share * (stroke.getY2() - stroke.getY1()));
    }

    private static Line2D part(Line2D stroke, double start, double end) {
        return new Line2D.Double(at(stroke, start), at(stroke, end));
    }
}
