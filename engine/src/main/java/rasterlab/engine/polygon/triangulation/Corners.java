package rasterlab.engine.polygon.triangulation;

import java.util.Arrays;
import rasterlab.engine.geometry.Orientation;
import rasterlab.engine.polygon.MeetingEdges;
import rasterlab.engine.range.Finite;

/**
 * A polygon's corners without repetitions, counter-clockwise, each with its number in the input.
 *
 * <p>A corner equal to the one before it is passed over, and so are last corners equal to the
 * first.
 */
final class Corners {
    final double[] x;
    final double[] y;
    final int[] number;

    private Corners(double[] x, double[] y, int[] number) {
        this.x = x;
        this.y = y;
        this.number = number;
    }

    /**
     * Reads the corners of a simple polygon, whichever way round, or of one with {@link Bridges}.
     *
     * @param most the most corners the method takes
     * @throws IllegalArgumentException if a coordinate is not finite, fewer than 3 or more than
     *     {@code most} corners are left, or the polygon crosses or touches itself or has no area
     */
    static Corners ofSimple(double[] x, double[] y, int most) {
        Corners corners = distinct(x, y, most);
        var places = Places.of(corners);
        if (places.shared()) {
            boolean clockwise = new Bridges(corners, places).requireUsable();
            return clockwise ? corners.reversed() : corners;
        }
        MeetingEdges.of(corners.x, corners.y)
                .ifPresent(
                        pair -> {
                            throw corners.meeting(pair);
                        });
        return corners.clockwise() ? corners.reversed() : corners;
    }

    /**
     * The corners as {@link #ofSimple} has them, but in the order given and with crossings not
     * looked for.
     */
    static Corners distinct(double[] x, double[] y, int most) {
        Finite.requirePoints("corner", x, y, 3);
        requireAtMost(most, x.length);
        var kept = new int[x.length];
        int size = 0;
        for (int i = 0; i < x.length; i++)
            if (size == 0 || differ(x, y, i, kept[size - 1])) kept[size++] = i;
        while (size > 1 && !differ(x, y, kept[size - 1], kept[0])) size--;
        if (size < 3)
            throw new IllegalArgumentException(
                    "at least 3 different corners are needed, got " + size);
        int[] number = Arrays.copyOf(kept, size);
        return new Corners(picked(x, number), picked(y, number), number);
    }

    /**
     * @throws IllegalArgumentException if there are more corners than {@code most}
     */
    static void requireAtMost(int most, int corners) {
        if (corners > most)
            throw new IllegalArgumentException(
                    "at most " + most + " corners are taken, got " + corners);
    }

    private static boolean differ(double[] x, double[] y, int i, int j) {
        return x[i] != x[j] || y[i] != y[j];
    }

    private static double[] picked(double[] values, int[] number) {
        return Arrays.stream(number).mapToDouble(i -> values[i]).toArray();
    }

    IllegalArgumentException meeting(MeetingEdges.EdgePair pair) {
        return new IllegalArgumentException(
                "edges may meet only at the corner they share, but those from corners "
                        + number[pair.one()]
                        + " and "
                        + number[pair.other()]
                        + " meet elsewhere");
    }

    int size() {
        return number.length;
    }

    /** Exact turn at j on the way from i to k: 1 to the left, −1 to the right, 0 straight. */
    int turn(int i, int j, int k) {
        return Orientation.of(x[i], y[i], x[j], y[j], x[k], y[k]);
    }

    int after(int i) {
        return i + 1 == size() ? 0 : i + 1;
    }

    int before(int i) {
        return i == 0 ? size() - 1 : i - 1;
    }

    /** The leftmost corner of a simple polygon is convex: its turn is the polygon's. */
    private boolean clockwise() {
        int leftmost = 0;
        for (int i = 1; i < size(); i++) if (leftOf(i, leftmost)) leftmost = i;
        return turn(before(leftmost), leftmost, after(leftmost)) < 0;
    }

    /** Whether corner i comes before j from left to right, and below it where x is the same. */
    private boolean leftOf(int i, int j) {
        return x[i] < x[j] || x[i] == x[j] && y[i] < y[j];
    }

    private Corners reversed() {
        int n = size();
        var backX = new double[n];
        var backY = new double[n];
        var backNumber = new int[n];
        for (int i = 0; i < n; i++) {
            backX[i] = x[n - 1 - i];
            backY[i] = y[n - 1 - i];
            backNumber[i] = number[n - 1 - i];
        }
        return new Corners(backX, backY, backNumber);
    }
}
