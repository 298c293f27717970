package rasterlab.engine.surface;

import java.util.function.BiConsumer;

/**
 * A line's width, its ends and joins, and its dashes.
 *
 * <p>Each piece of the line is a rectangle of the pen's width along it; where two pieces meet, a
 * round join fills the gap at the outside of the bend. A pattern of dashes is measured along the
 * line and goes on around corners. Two equal points one after the other are a piece without length:
 * within a stroke a round pen draws a dot there, another pen nothing. A single point is no line.
 *
 * @param width in pixels, above 0
 * @param round whether ends and joins are round; otherwise ends are cut off square at the points
 *     and joins stay open
 * @param dashes lengths in pixels of a stroke, a gap, a stroke, …, an even number, each at least
 *     {@value #SHORTEST}; empty for an unbroken line
 */
public record Pen(double width, boolean round, double... dashes) {
    /** The shortest dash or gap, so that no line falls into more pieces than pixels. */
    public static final double SHORTEST = 0.25;

    /** The longest line, in pixels, that is drawn in dashes. */
    public static final double LONGEST = 1e6;

    /** How far a round end's polygon is from the circle at most, in pixels. */
    private static final double ROUNDNESS = 0.25;

    private static final int FEWEST_CORNERS = 8;

    public Pen {
        if (!(width > 0 && width <= LONGEST))
            throw new IllegalArgumentException(
                    "width must be above 0 and at most 1000000 pixels, got " + width);
        if (dashes.length % 2 != 0)
            throw new IllegalArgumentException(
                    "dashes must be an even number of lengths, got " + dashes.length);
        for (int i = 0; i < dashes.length; i++)
            if (!(dashes[i] >= SHORTEST && dashes[i] <= LONGEST))
                throw new IllegalArgumentException(
                        "length %d of the dashes must be from 0.25 to 1000000 pixels, got %s"
                                .formatted(i, dashes[i]));
        dashes = dashes.clone();
    }

    /** A copy. */
    @Override
    public double[] dashes() {
        return dashes.clone();
    }

    /** Sends the polygons, x and y of the corners, that together cover the line. */
    void outline(double[] x, double[] y, BiConsumer<double[], double[]> polygons) {
        requireShort(x, y);
        int dash = 0;
        double left = dashes.length == 0 ? Double.POSITIVE_INFINITY : dashes[0];
        for (int i = 0; i + 1 < x.length; i++) {
            double length = Math.hypot(x[i + 1] - x[i], y[i + 1] - y[i]);
            double from = 0;
            while (length - from > left) {
                if (dash % 2 == 0) piece(x, y, i, from / length, (from + left) / length, polygons);
                from += left;
                dash = (dash + 1) % dashes.length;
                left = dashes[dash];
            }
            if (dash % 2 == 0 && length == 0 && round) circle(x[i], y[i], polygons);
            if (dash % 2 == 0 && length > from) piece(x, y, i, from / length, 1, polygons);
            left -= length - from;
        }
    }

    private static void requireShort(double[] x, double[] y) {
        if (x.length != y.length)
            throw new IllegalArgumentException(
                    "a line needs as many x as y, got " + x.length + " and " + y.length);
        double length = 0;
        for (int i = 0; i + 1 < x.length; i++) {
            length += Math.hypot(x[i + 1] - x[i], y[i + 1] - y[i]);
            if (!(length <= LONGEST))
                throw new IllegalArgumentException(
                        "a line must have at most 1000000 pixels, got %s up to point %d"
                                .formatted(length, i + 1));
        }
    }

    /** Draws the part of the line after point {@code i} from one share of its length to another. */
    private void piece(
            double[] x,
            double[] y,
            int i,
            double from,
            double to,
            BiConsumer<double[], double[]> polygons) {
        double dx = x[i + 1] - x[i];
        double dy = y[i + 1] - y[i];
        double half = width / 2 / Math.hypot(dx, dy);
        double acrossX = -dy * half;
        double acrossY = dx * half;
        double startX = x[i] + from * dx;
        double startY = y[i] + from * dy;
        double endX = x[i] + to * dx;
        double endY = y[i] + to * dy;
        polygons.accept(
                new double[] {startX + acrossX, endX + acrossX, endX - acrossX, startX - acrossX},
                new double[] {startY + acrossY, endY + acrossY, endY - acrossY, startY - acrossY});
        if (round) {
            circle(startX, startY, polygons);
            circle(endX, endY, polygons);
        }
    }

    private void circle(double x, double y, BiConsumer<double[], double[]> polygons) {
        int corners = corners(width / 2);
        var cornerX = new double[corners];
        var cornerY = new double[corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            cornerX[i] = x + width / 2 * Math.cos(angle);
            cornerY[i] = y + width / 2 * Math.sin(angle);
        }
        polygons.accept(cornerX, cornerY);
    }

    /** The middle of a side between corners 2·π/n apart is r·(1 − cos(π/n)) inside the circle. */
    static int corners(double radius) {
        double halfAngle = Math.acos(Math.max(0, 1 - ROUNDNESS / radius));
        return Math.max(FEWEST_CORNERS, (int) Math.ceil(Math.PI / halfAngle));
    }
}
