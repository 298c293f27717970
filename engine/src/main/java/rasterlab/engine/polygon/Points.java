package rasterlab.engine.polygon;

import java.util.Arrays;
import rasterlab.engine.range.Finite;

/**
 * Points of the plane in order, such as a polygon's corners. Coordinates are finite.
 *
 * @param x taken as it is, not to be changed any more
 * @param y as many as {@code x}; the same
 */
public record Points(double[] x, double[] y) {
    public Points {
        Finite.requirePoints("point", x, y, 0);
    }

    /** The points (x0, y0), (x1, y1), … */
    public static Points of(double... xy) {
        if (xy.length % 2 != 0)
            throw new IllegalArgumentException("points need an even count, got " + xy.length);
        var x = new double[xy.length / 2];
        var y = new double[xy.length / 2];
        for (int i = 0; i < x.length; i++) {
            x[i] = xy[2 * i];
            y[i] = xy[2 * i + 1];
        }
        return new Points(x, y);
    }

    public int size() {
        return x.length;
    }

    public double x(int i) {
        return x[i];
    }

    public double y(int i) {
        return y[i];
    }

    /** All x, copied. */
    public double[] xs() {
        return x.clone();
    }

    /** All y, copied. */
    public double[] ys() {
        return y.clone();
    }

    /** x and y of each point in turn. */
    public double[] numbers() {
        var numbers = new double[2 * x.length];
        for (int i = 0; i < x.length; i++) {
            numbers[2 * i] = x[i];
            numbers[2 * i + 1] = y[i];
        }
        return numbers;
    }

    /** These points, last first: a polygon that goes round the other way. */
    public Points reversed() {
        var backX = new double[x.length];
        var backY = new double[y.length];
        for (int i = 0; i < x.length; i++) {
            backX[i] = x[x.length - 1 - i];
            backY[i] = y[y.length - 1 - i];
        }
        return new Points(backX, backY);
    }

    /** Each coordinate times {@code factor}. */
    public Points scaled(double factor) {
        return new Points(
                Arrays.stream(x).map(v -> factor * v).toArray(),
                Arrays.stream(y).map(v -> factor * v).toArray());
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Points points
                && Arrays.equals(x, points.x)
                && Arrays.equals(y, points.y);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(x) + Arrays.hashCode(y);
    }

    @Override
    public String toString() {
        var text = new StringBuilder("[");
        for (int i = 0; i < Math.min(x.length, 8); i++)
            text.append(i == 0 ? "" : ", ").append("(" + x[i] + ", " + y[i] + ")");
        return text.append(x.length > 8 ? ", … " + x.length + " points]" : "]").toString();
    }
}
