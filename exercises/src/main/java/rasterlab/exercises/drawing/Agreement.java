package rasterlab.exercises.drawing;

/** Decides whether a cell of a table is right. */
@FunctionalInterface
public interface Agreement {
    boolean holds(int row, int column, double expected, double actual);

    /**
     * Agrees where |actual − expected| is at most the tolerance; equal infinities agree, and so do
     * NaNs.
     *
     * @param tolerance in the unit of the numbers, at least 0
     */
    static Agreement within(double tolerance) {
        if (!(tolerance >= 0))
            throw new IllegalArgumentException("tolerance must be at least 0, got " + tolerance);
        return (row, column, expected, actual) ->
                expected == actual
                        || Double.isNaN(expected) && Double.isNaN(actual)
                        || Double.isFinite(expected)
                                && Double.isFinite(actual)
                                && Math.abs(actual - expected) <= tolerance;
    }
}
