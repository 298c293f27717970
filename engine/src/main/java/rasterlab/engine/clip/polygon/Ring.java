package rasterlab.engine.clip.polygon;

import java.util.Arrays;
import java.util.stream.IntStream;
import rasterlab.engine.geometry.Orientation;
import rasterlab.engine.polygon.MeetingEdges;
import rasterlab.engine.range.Finite;

/**
 * A closed polygon as corners, none equal to the one before, in either direction; {@link
 * ConvexWindow} and {@link #simple} turn theirs counter-clockwise (y grows up).
 *
 * @param xy x and y of each corner in turn
 */
public record Ring(double[] xy) {
    /** The most corners of a polygon to clip. */
    static final int MOST_CORNERS = 1 << 24;

    public Ring {
        xy = xy.clone();
    }

    int size() {
        return xy.length / 2;
    }

    double x(int corner) {
        return xy[2 * (corner % size())];
    }

    double y(int corner) {
        return xy[2 * (corner % size()) + 1];
    }

    /** Side of the edge from {@code corner} to the next on which a point lies: 1 left, 0 on it. */
    int side(int corner, double x, double y) {
        return Orientation.of(x(corner), y(corner), x(corner + 1), y(corner + 1), x, y);
    }

    /** 1 where the ring turns left at a corner, 0 where it goes straight on or back. */
    int turn(int corner) {
        int before = corner == 0 ? size() - 1 : corner - 1;
        return side(before, x(corner + 1), y(corner + 1));
    }

    /**
     * A ring of these corners, without those that repeat the one before.
     *
     * @param name of the polygon, for messages
     * @throws IllegalArgumentException if a number is not finite or fewer than three corners are
     *     left
     */
    static Ring of(String name, double[] corners) {
        if (corners.length % 2 != 0)
            throw new IllegalArgumentException(
                    name
                            + " must have an x and a y for each corner, got "
                            + corners.length
                            + " numbers");
        requireFinite(name, corners);
        double[] distinct = withoutRepeats(corners);
        if (distinct.length < 6 || distinct.length > 2 * MOST_CORNERS)
            throw new IllegalArgumentException(
                    name
                            + " must have from 3 to "
                            + MOST_CORNERS
                            + " different corners, got "
                            + distinct.length / 2);
        return new Ring(distinct);
    }

    /**
     * A polygon whose edges meet only at the corner they share, counter-clockwise.
     *
     * @throws IllegalArgumentException as {@link #of}, or if edges meet elsewhere; names them
     */
    static Ring simple(double[] corners) {
        Ring ring = of("polygon", corners);
        MeetingEdges.of(ring.axis(0), ring.axis(1))
                .ifPresent(
                        pair -> {
                            throw ring.meeting(pair);
                        });
        return ring.turn(ring.lowest()) < 0 ? ring.reversed() : ring;
    }

    private double[] axis(int axis) {
        return IntStream.range(0, size()).mapToDouble(i -> xy[2 * i + axis]).toArray();
    }

    private IllegalArgumentException meeting(MeetingEdges.EdgePair pair) {
        String one = place(pair.one());
        String other = place(pair.other());
        return new IllegalArgumentException(
                "polygon must be simple, but "
                        + (one.equals(other)
                                ? "corner " + one + " is there twice"
                                : "the edges from corners " + one + " and " + other + " meet"));
    }

    /** A corner, for messages. */
    String place(int corner) {
        return "(" + x(corner) + ", " + y(corner) + ")";
    }

    private static void requireFinite(String name, double[] corners) {
        var x = new double[corners.length / 2];
        var y = new double[x.length];
        for (int i = 0; i < x.length; i++) {
            x[i] = corners[2 * i];
            y[i] = corners[2 * i + 1];
        }
        Finite.requirePoints(name + " corner", x, y, 0);
    }

    /** The corners without those equal to the one before, the last being before the first. */
    static double[] withoutRepeats(double[] corners) {
        var kept = new double[corners.length];
        int size = 0;
        for (int i = 0; i < corners.length; i += 2)
            if (size == 0 || kept[size - 2] != corners[i] || kept[size - 1] != corners[i + 1]) {
                kept[size++] = corners[i] + 0.0;
                kept[size++] = corners[i + 1] + 0.0;
            }
        while (size > 2 && kept[0] == kept[size - 2] && kept[1] == kept[size - 1]) size -= 2;
        return Arrays.copyOf(kept, size);
    }

    /** The corner that comes first by x, and by y among equal x: it is convex for sure. */
    int lowest() {
        int lowest = 0;
        for (int i = 1; i < size(); i++)
            if (x(i) < x(lowest) || x(i) == x(lowest) && y(i) < y(lowest)) lowest = i;
        return lowest;
    }

    /** These corners the other way round, the first staying first. */
    Ring reversed() {
        var other = new double[xy.length];
        for (int i = 0; i < size(); i++) {
            int from = (size() - i) % size();
            other[2 * i] = x(from);
            other[2 * i + 1] = y(from);
        }
        return new Ring(other);
    }
}
