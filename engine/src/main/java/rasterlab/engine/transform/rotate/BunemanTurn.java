package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Arithmetic;

/** One point turned again and again by three shears. */
final class BunemanTurn {
    private BunemanTurn() {}

    /**
     * @param t tan θ/2
     * @param sin sin θ
     */
    static void repeat(Arithmetic on, double t, double sin, int times, double[] points, int at) {
        double x = points[at];
        double y = points[at + 1];
        for (int i = 0; i < times; i++) {
            double sheared = on.plus(y, on.times(x, t));
            x = on.minus(x, on.times(sheared, sin));
            y = on.plus(on.times(x, t), sheared);
        }
        points[at] = x;
        points[at + 1] = y;
    }
}
