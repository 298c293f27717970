package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Arithmetic;

/** One point turned again and again: [x y] · [cos sin; −sin cos]. */
final class PointTurn {
    private PointTurn() {}

    /** Turns the point whose x stands at {@code at}. */
    static void repeat(Arithmetic on, Angle by, int times, double[] points, int at) {
        double x = points[at];
        double y = points[at + 1];
        for (int i = 0; i < times; i++) {
            double turned = on.minus(on.times(x, by.cos()), on.times(y, by.sin()));
            y = on.plus(on.times(x, by.sin()), on.times(y, by.cos()));
            x = turned;
        }
        points[at] = x;
        points[at + 1] = y;
    }
}
