package rasterlab.engine.polygon;

import java.util.Arrays;

/** Which of several points are inside: the output of a method that judges point after point. */
public final class Membership {
    private final boolean[] inside;

    /** The judge of one point. */
    @FunctionalInterface
    public interface PointClassifier {
        boolean contains(double x, double y);
    }

    /**
     * Judges the first {@code limit} points, or all if there are fewer.
     *
     * @param limit at least 0
     */
    public Membership(Points points, int limit, PointClassifier judge) {
        inside = new boolean[Math.min(limit, points.size())];
        for (int i = 0; i < inside.length; i++)
            inside[i] = judge.contains(points.x(i), points.y(i));
    }

    public int size() {
        return inside.length;
    }

    public boolean inside(int i) {
        return inside[i];
    }

    @Override
    public String toString() {
        return Arrays.toString(inside);
    }
}
