package rasterlab.exercises.drawing;

/**
 * A point of the plane, in the units of a case's input.
 *
 * @param x any double, NaN and infinities too
 * @param y any double, NaN and infinities too
 */
public record CasePoint(double x, double y) {
    boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y);
    }

    /**
     * Whether no coordinate differs by more than that; NaN and infinities agree with themselves.
     */
    boolean isNear(CasePoint other, double tolerance) {
        return isNear(x, other.x, tolerance) && isNear(y, other.y, tolerance);
    }

    /** The larger difference of a coordinate; infinite where one is not finite and they differ. */
    double distance(CasePoint other) {
        if (isNear(other, 0)) return 0;
        double most = Math.max(Math.abs(x - other.x), Math.abs(y - other.y));
        return Double.isNaN(most) ? Double.POSITIVE_INFINITY : most;
    }

    private static boolean isNear(double one, double other, double tolerance) {
        return one == other
                || Double.isNaN(one) && Double.isNaN(other)
                || Double.isFinite(one)
                        && Double.isFinite(other)
                        && Math.abs(one - other) <= tolerance;
    }
}
