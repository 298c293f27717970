package rasterlab.engine.polygon.scan;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.stream.DoubleStream;
import rasterlab.contract.Spans;

/**
 * The reference: each row's crossing with each edge as a fraction of whole numbers.
 *
 * <p>Every double is a decimal fraction, so all coordinates are whole multiples of one power of
 * ten; rows and columns are counted in that unit.
 */
final class ExactFill {
    private final PolygonTask task;
    private final BigInteger pixel;
    private final BigInteger[] x;
    private final BigInteger[] y;

    ExactFill(PolygonTask task) {
        this.task = task;
        int digits =
                DoubleStream.concat(DoubleStream.of(task.x()), DoubleStream.of(task.y()))
                        .mapToInt(value -> new BigDecimal(value).scale())
                        .max()
                        .orElse(0);
        pixel = BigInteger.TEN.pow(digits);
        x = inUnits(task.x(), digits);
        y = inUnits(task.y(), digits);
    }

    private static BigInteger[] inUnits(double[] values, int digits) {
        return DoubleStream.of(values)
                .mapToObj(value -> new BigDecimal(value).setScale(digits).unscaledValue())
                .toArray(BigInteger[]::new);
    }

    /** Sends the spans of every row. */
    void fill(Spans out) {
        for (int row = 0; row < task.height(); row++) fillRow(row, changes(row), out);
    }

    /** Growth of the winding number at each column; left of the picture counts as 0. */
    private int[] changes(int row) {
        var changes = new int[task.width() + 1];
        BigInteger level = pixel.multiply(BigInteger.valueOf(row));
        for (int i = 0; i < x.length; i++) {
            int end = (i + 1) % x.length;
            boolean begun = y[i].compareTo(level) <= 0;
            boolean ended = y[end].compareTo(level) <= 0;
            if (begun != ended) changes[column(i, end, level)] += begun ? 1 : -1;
        }
        return changes;
    }

    private int column(int start, int end, BigInteger level) {
        BigInteger dy = y[end].subtract(y[start]);
        BigInteger along = level.subtract(y[start]).multiply(x[end].subtract(x[start]));
        BigInteger crossing = x[start].multiply(dy).add(along);
        BigInteger[] split = crossing.divideAndRemainder(dy.multiply(pixel));
        boolean between = split[1].signum() != 0;
        boolean positive = crossing.signum() == dy.signum();
        BigInteger column = between && positive ? split[0].add(BigInteger.ONE) : split[0];
        BigInteger width = BigInteger.valueOf(task.width());
        return column.max(BigInteger.ZERO).min(width).intValue();
    }

    private void fillRow(int row, int[] changes, Spans out) {
        int winding = 0;
        int from = 0;
        for (int column = 0; column <= task.width(); column++) {
            boolean wasInside = task.rule().inside(winding);
            winding += changes[column];
            boolean isInside = task.rule().inside(winding);
            if (!wasInside && isInside) from = column;
            if (wasInside && !isInside) out.span(row, from, column);
        }
    }
}
