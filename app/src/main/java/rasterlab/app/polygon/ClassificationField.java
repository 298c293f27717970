package rasterlab.app.polygon;

import java.awt.Rectangle;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.engine.polygon.Membership;

/**
 * The answers of two judges for a grid of points that covers the view.
 *
 * <p>The points are the whole multiples of a power of two, so that their coordinates are exact and
 * many of them lie on a polygon's sides and at the height of its corners, where methods fail.
 */
final class ClassificationField {
    /** View units between points, at least; less than twice as many unless whole numbers do. */
    private static final double APART = 4;

    private static final byte FIRST = 1;
    private static final byte SECOND = 2;
    private static final byte FIRST_REFUSES = 4;
    private static final byte SECOND_REFUSES = 8;

    private final double step;
    private final double left;
    private final double low;
    private final int columns;
    private final int rows;
    private final byte[] verdicts;

    private ClassificationField(double step, double left, double low, int columns, int rows) {
        this.step = step;
        this.left = left;
        this.low = low;
        this.columns = columns;
        this.rows = rows;
        verdicts = new byte[columns * rows];
    }

    /**
     * @param leastStep a power of two that the points are at least apart, or 0
     * @throws CancellationException soon after {@code cancelled} says true
     */
    static ClassificationField of(
            PlaneMap map,
            Rectangle view,
            double leastStep,
            Membership.PointClassifier first,
            Membership.PointClassifier second,
            BooleanSupplier cancelled) {
        double fine = Math.scalb(1.0, Math.getExponent(map.worldWidth(APART)) + 1);
        double step = Math.max(leastStep, fine);
        double left = Math.floor(map.worldX(view.getMinX()) / step);
        double right = Math.ceil(map.worldX(view.getMaxX()) / step);
        double low = Math.floor(map.worldY(view.getMaxY()) / step);
        double high = Math.ceil(map.worldY(view.getMinY()) / step);
        var field =
                new ClassificationField(
                        step, left, low, (int) (right - left) + 1, (int) (high - low) + 1);
        for (int row = 0; row < field.rows; row++) {
            if (cancelled.getAsBoolean())
                throw new CancellationException("a newer frame is asked for");
            for (int column = 0; column < field.columns; column++)
                field.verdicts[row * field.columns + column] =
                        verdict(field.x(column), field.y(row), first, second);
        }
        return field;
    }

    private static byte verdict(
            double x,
            double y,
            Membership.PointClassifier first,
            Membership.PointClassifier second) {
        return (byte)
                (verdict(x, y, first, FIRST, FIRST_REFUSES)
                        | verdict(x, y, second, SECOND, SECOND_REFUSES));
    }

    private static int verdict(
            double x, double y, Membership.PointClassifier judge, byte inside, byte refused) {
        if (!Double.isFinite(x) || !Double.isFinite(y)) return refused;
        try {
            return judge.contains(x, y) ? inside : 0;
        } catch (IllegalArgumentException e) {
            return refused;
        }
    }

    int columns() {
        return columns;
    }

    int rows() {
        return rows;
    }

    /** Distance between neighbouring points, in the plane's units. */
    double step() {
        return step;
    }

    double x(int column) {
        return (left + column) * step;
    }

    double y(int row) {
        return (low + row) * step;
    }

    boolean first(int column, int row) {
        return has(column, row, FIRST);
    }

    boolean second(int column, int row) {
        return has(column, row, SECOND);
    }

    /** Whether the first judge cannot tell. */
    boolean refused(int column, int row) {
        return has(column, row, FIRST_REFUSES);
    }

    /** Whether both judge the point, and differently. */
    boolean differ(int column, int row) {
        byte verdict = verdicts[row * columns + column];
        return (verdict & (FIRST_REFUSES | SECOND_REFUSES)) == 0
                && first(column, row) != second(column, row);
    }

    /** How many points both judge. */
    long judged() {
        long judged = 0;
        for (byte verdict : verdicts)
            if ((verdict & (FIRST_REFUSES | SECOND_REFUSES)) == 0) judged++;
        return judged;
    }

    /** How many points both judge, and differently. */
    long differing() {
        long differing = 0;
        for (int row = 0; row < rows; row++)
            for (int column = 0; column < columns; column++) if (differ(column, row)) differing++;
        return differing;
    }

    private boolean has(int column, int row, byte bit) {
        return (verdicts[row * columns + column] & bit) != 0;
    }
}
