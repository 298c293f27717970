package rasterlab.engine.spline.exact;

import java.util.Arrays;
import rasterlab.contract.CurvePoints;
import rasterlab.engine.study.LimitReached;

/** Points in the order they came. */
public final class Polyline implements CurvePoints {
    private final int limit;
    private double[] x = new double[64];
    private double[] y = new double[64];
    private int size;

    /**
     * @param limit the most points it takes
     */
    public Polyline(int limit) {
        this.limit = limit;
    }

    /**
     * @throws LimitReached when it is full; carries itself
     */
    @Override
    public void point(double pointX, double pointY) {
        if (size == limit) throw new LimitReached(limit, this);
        if (size == x.length) {
            x = Arrays.copyOf(x, 2 * size);
            y = Arrays.copyOf(y, 2 * size);
        }
        x[size] = pointX;
        y[size++] = pointY;
    }

    public int size() {
        return size;
    }

    public double x(int i) {
        return x[i];
    }

    public double y(int i) {
        return y[i];
    }
}
