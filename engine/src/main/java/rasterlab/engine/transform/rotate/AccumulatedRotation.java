package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;
import rasterlab.engine.transform.Arithmetic;

/**
 * Turns an orientation instead of the points, repairs its length in every turn and applies it to
 * the points once, at the end: the radius cannot drift, the angle still can.
 */
abstract class AccumulatedRotation extends CountedRotation {
    /** The cosine and sine of the orientation, or of its half, after {@code times} turns. */
    static Angle accumulate(Arithmetic on, Angle by, int times) {
        double c = by.cos();
        double s = by.sin();
        for (int i = 1; i < times; i++) {
            double turned = on.minus(on.times(c, by.cos()), on.times(s, by.sin()));
            s = on.plus(on.times(c, by.sin()), on.times(s, by.cos()));
            c = turned;
            // One step of Newton's for 1/√q from 1: (3 − q)/2, q being next to 1.
            double q = on.plus(on.times(c, c), on.times(s, s));
            double repair = on.times(0.5, on.minus(3, q));
            c = on.times(c, repair);
            s = on.times(s, repair);
        }
        return new Angle(s, c);
    }
}
