package rasterlab.engine.spline.curve;

import rasterlab.contract.CurvePoints;
import rasterlab.engine.study.LimitReached;

/** Counts points and adds up their places, so that a compiler cannot leave them uncomputed. */
final class CountingPoints implements CurvePoints {
    private final long limit;
    private long count;
    private double places;

    CountingPoints(long limit) {
        this.limit = limit;
    }

    @Override
    public void point(double x, double y) {
        if (count == limit) throw new LimitReached((int) limit, null);
        count++;
        places += x + y;
    }

    long count() {
        if (Double.isNaN(places)) throw new AssertionError("a point is not a number");
        return count;
    }
}
