package rasterlab.engine.transform.rotate;

import java.util.Map;
import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.CountingArithmetic;

/** {@link TurnLoops} operation by operation, each of them counted. */
final class CountingTurnLoops extends TurnLoops {
    private final CountingArithmetic on = new CountingArithmetic();

    Map<String, Long> counts() {
        return on.counts();
    }

    @Override
    void turn(Angle by, int times, double[] points) {
        for (int at = 0; at < points.length; at += 2)
            for (int i = 0; i < times; i++) {
                double x = points[at];
                double y = points[at + 1];
                points[at] = on.minus(on.times(x, by.cos()), on.times(y, by.sin()));
                points[at + 1] = on.plus(on.times(x, by.sin()), on.times(y, by.cos()));
            }
    }

    /** A double result of two floats, rounded to float, is what float arithmetic gives. */
    @Override
    void turnInFloat(Angle by, int times, double[] points) {
        float sin = (float) by.sin();
        float cos = (float) by.cos();
        for (int i = 0; i < points.length; i++) points[i] = (float) points[i];
        for (int at = 0; at < points.length; at += 2)
            for (int i = 0; i < times; i++) {
                double x = points[at];
                double y = points[at + 1];
                points[at] = (float) on.minus((float) on.times(x, cos), (float) on.times(y, sin));
                points[at + 1] =
                        (float) on.plus((float) on.times(x, sin), (float) on.times(y, cos));
            }
    }

    @Override
    void shear(double t, double sin, int times, double[] points) {
        for (int at = 0; at < points.length; at += 2)
            for (int i = 0; i < times; i++) {
                double sheared = on.plus(points[at + 1], on.times(points[at], t));
                points[at] = on.minus(points[at], on.times(sheared, sin));
                points[at + 1] = on.plus(on.times(points[at], t), sheared);
            }
    }

    @Override
    Angle accumulate(Angle by, int times) {
        double c = by.cos();
        double s = by.sin();
        for (int i = 1; i < times; i++) {
            double turned = on.minus(on.times(c, by.cos()), on.times(s, by.sin()));
            s = on.plus(on.times(c, by.sin()), on.times(s, by.cos()));
            c = turned;
            double q = on.plus(on.times(c, c), on.times(s, s));
            double repair = on.times(0.5, on.minus(3, q));
            c = on.times(c, repair);
            s = on.times(s, repair);
        }
        return new Angle(s, c);
    }

    @Override
    Angle twice(Angle half) {
        double zw = on.times(half.sin(), half.cos());
        double cos = on.times(on.minus(half.cos(), half.sin()), on.plus(half.cos(), half.sin()));
        return new Angle(on.plus(zw, zw), cos);
    }
}
