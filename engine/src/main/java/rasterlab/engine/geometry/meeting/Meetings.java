package rasterlab.engine.geometry.meeting;

import java.util.Arrays;
import java.util.Optional;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.study.Deviation;

/**
 * The μ of several lines with the points and parts of the lines that they name: the output of a
 * method of topic {@code line-plane}.
 */
public final class Meetings {
    private final double[] mu;

    /** null where μ is no number. */
    private final Line.PositionOnLine[] parts;

    /** x, y, z of each point; null where there is none within doubles. */
    private final double[][] points;

    Meetings(double[] mu, Line.PositionOnLine[] parts, double[][] points) {
        this.mu = mu;
        this.parts = parts;
        this.points = points;
    }

    /** The part of the line that the μ of a method names. */
    static Meetings of(double[] mu, PlaneAndLines input) {
        var parts = new Line.PositionOnLine[mu.length];
        var points = new double[mu.length][];
        for (int i = 0; i < mu.length; i++) {
            if (!Double.isFinite(mu[i])) continue;
            parts[i] = Line.part(mu[i]);
            double at = mu[i];
            points[i] = input.lineWithin(i).map(line -> numbers(line.at(at))).orElse(null);
        }
        return new Meetings(mu, parts, points);
    }

    /**
     * The point that one μ names.
     *
     * @param point null where μ is no number
     */
    static Meetings ofOne(double mu, double[] point) {
        Line.PositionOnLine part = point == null ? null : Line.part(mu);
        return new Meetings(
                new double[] {mu}, new Line.PositionOnLine[] {part}, new double[][] {point});
    }

    private static double[] numbers(Vector v) {
        return new double[] {v.x(), v.y(), v.z()};
    }

    public int size() {
        return mu.length;
    }

    public double mu(int line) {
        return mu[line];
    }

    /** Whether a line's μ names a point within doubles. */
    boolean hasPoint(int line) {
        return points[line] != null;
    }

    /** That point: x, y, z. */
    double[] point(int line) {
        return points[line].clone();
    }

    Meetings first(int count) {
        int size = Math.min(count, mu.length);
        return new Meetings(
                Arrays.copyOf(mu, size), Arrays.copyOf(parts, size), Arrays.copyOf(points, size));
    }

    /**
     * How far answers are from these exact ones; 1 where only one of the two is a number. A line
     * whose part is told wrong counts as missing.
     */
    Deviation deviation(PlaneAndLines input, Meetings actual) {
        double worst = 0;
        long missing = 0;
        long extra = 0;
        String first = "";
        for (int i = 0; i < mu.length; i++) {
            boolean meets = Double.isFinite(mu[i]);
            boolean told = i < actual.size() && Double.isFinite(actual.mu[i]);
            double error = meets && told ? error(input, i, actual) : 1;
            Optional<String> difference = difference(i, actual, error, meets && told);
            if (difference.isEmpty()) continue;
            if (!meets) extra++;
            if (meets && (!told || parts[i] != actual.parts[i])) missing++;
            worst = Math.max(worst, error);
            if (first.isEmpty()) first = difference.get();
        }
        return new Deviation(worst, missing, extra, mu.length, first);
    }

    private double error(PlaneAndLines input, int line, Meetings actual) {
        double error = Math.abs(actual.mu[line] - mu[line]) / Math.max(1, Math.abs(mu[line]));
        double[] right = points[line];
        double[] point = actual.points[line];
        if (right == null || point == null) return error;
        double[] from = input.from()[line];
        double size = Double.MIN_NORMAL;
        double apart = 0;
        for (int axis = 0; axis < 3; axis++) {
            double way = Math.abs(right[axis] - from[axis]);
            size = Math.max(size, Math.max(Math.abs(from[axis]), way));
            apart = Math.max(apart, Math.abs(point[axis] - right[axis]));
        }
        return Double.isFinite(size) ? Math.max(error, apart / size) : error;
    }

    /** The fault of a line in words, if there is one. */
    private Optional<String> difference(int line, Meetings actual, double error, boolean both) {
        if (both && parts[line] != actual.parts[line])
            return Optional.of(
                    "line %d has μ %s, in another part of the line than %s"
                            .formatted(line, mu[line], actual.mu[line]));
        if (error == 0) return Optional.empty();
        return Optional.of(
                "line " + line + " has μ " + mu[line] + ", got " + actual.lineText(line));
    }

    private String lineText(int line) {
        return line < mu.length ? "" + mu[line] : "none";
    }

    @Override
    public String toString() {
        return Arrays.toString(mu);
    }
}
