package rasterlab.engine.border;

import rasterlab.contract.Curve;
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.spline.exact.CurveTask;

/** Curves of every kind, points of them and polylines. */
final class CurveBorders {
    private static final double LARGEST = 1e100;

    /** Finer ones have too many segments to look at thousands of them. */
    private static final double FINEST = 1.0 / 64;

    private CurveBorders() {}

    static Border<?, ?, ?> all() {
        return Border.of(
                new CurveTopic(),
                CurveBorders::curve,
                (method, task, message) ->
                        task.flatness() > 0 && task.flatness() < 0x1p-40 * task.curve().size());
    }

    private static CurveTask curve(Draws draws) {
        Curve.Kind kind = Curve.Kind.values()[draws.pick(Curve.Kind.values().length)];
        int points = kind == Curve.Kind.BEZIER ? 1 + draws.pick(7) : 4;
        if (kind != Curve.Kind.BEZIER && kind != Curve.Kind.HERMITE) points += draws.pick(2);
        var x = new double[points];
        var y = new double[points];
        for (int i = 0; i < points; i++) {
            x[i] = draws.number(-LARGEST, LARGEST);
            y[i] = draws.number(-LARGEST, LARGEST);
        }
        var curve = new Curve(kind, x, y);
        if (draws.pick(4) < 3)
            return new CurveTask(curve, new double[] {draws.number(0, 1), draws.number(0, 1)}, 0);
        double finest = Math.max(1e-100, curve.size() * FINEST);
        return new CurveTask(
                curve, new double[0], draws.number(Math.min(finest, LARGEST), LARGEST));
    }
}
