package rasterlab.engine.clip.polygon;

import java.util.Arrays;

/** Accepts windows that are convex and have an area, and turns them counter-clockwise. */
public final class ConvexWindow {
    private ConvexWindow() {}

    /**
     * The window without corners between whose neighbours its boundary goes straight on.
     *
     * @throws IllegalArgumentException if it has no area or is not convex; names the corner
     */
    public static Ring of(double[] corners) {
        Ring given = Ring.of("window", corners);
        Ring ring = strict(given);
        if (ring.size() < 3) throw new IllegalArgumentException("window must have an area above 0");
        requireNowhereBack(given);
        if (ring.turn(ring.lowest()) < 0) ring = ring.reversed();
        for (int i = 0; i < ring.size(); i++)
            if (ring.turn(i) <= 0)
                throw new IllegalArgumentException(
                        "window must be convex, but turns the other way at its corner "
                                + ring.place(i));
        requireOnce(ring);
        return ring;
    }

    private static Ring strict(Ring ring) {
        var kept = new double[ring.xy().length];
        int size = 0;
        for (int i = 0; i < ring.size(); i++)
            if (ring.turn(i) != 0) {
                kept[size++] = ring.x(i);
                kept[size++] = ring.y(i);
            }
        return new Ring(Arrays.copyOf(kept, size));
    }

    /** A corner without a turn may be the tip of a spike, where the boundary runs back. */
    private static void requireNowhereBack(Ring ring) {
        for (int i = 0; i < ring.size(); i++) {
            int before = i + ring.size() - 1;
            boolean between =
                    isBetween(ring.x(before), ring.x(i), ring.x(i + 1))
                            && isBetween(ring.y(before), ring.y(i), ring.y(i + 1));
            if (ring.turn(i) == 0 && !between)
                throw new IllegalArgumentException(
                        "window must be convex, but turns back at its corner " + ring.place(i));
        }
    }

    private static boolean isBetween(double one, double middle, double other) {
        return Math.min(one, other) <= middle && middle <= Math.max(one, other);
    }

    /** Turning left all the time, a ring may still go round twice: then x rises more than once. */
    private static void requireOnce(Ring ring) {
        int rises = 0;
        for (int i = 0; i < ring.size(); i++)
            if (!forward(ring, i + ring.size() - 1) && forward(ring, i)) rises++;
        if (rises > 1)
            throw new IllegalArgumentException(
                    "window must be convex, but goes round " + rises + " times");
    }

    private static boolean forward(Ring ring, int edge) {
        double from = ring.x(edge);
        double to = ring.x(edge + 1);
        return from < to || from == to && ring.y(edge) < ring.y(edge + 1);
    }
}
