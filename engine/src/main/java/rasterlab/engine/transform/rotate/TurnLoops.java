package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/**
 * The loops of all rotations, in plain operators. {@link CountingTurnLoops} does the same and
 * counts.
 */
class TurnLoops {
    /** Turns every point: [x y] · [cos sin; −sin cos], again and again. */
    void turn(Angle by, int times, double[] points) {
        double sin = by.sin();
        double cos = by.cos();
        for (int at = 0; at < points.length; at += 2) {
            double x = points[at];
            double y = points[at + 1];
            for (int i = 0; i < times; i++) {
                double turned = x * cos - y * sin;
                y = x * sin + y * cos;
                x = turned;
            }
            points[at] = x;
            points[at + 1] = y;
        }
    }

    /** Turns the points in float. */
    void turnInFloat(Angle by, int times, double[] points) {
        float sin = (float) by.sin();
        float cos = (float) by.cos();
        for (int at = 0; at < points.length; at += 2) {
            float x = (float) points[at];
            float y = (float) points[at + 1];
            for (int i = 0; i < times; i++) {
                float turned = x * cos - y * sin;
                y = x * sin + y * cos;
                x = turned;
            }
            points[at] = x;
            points[at + 1] = y;
        }
    }

    /**
     * Turns every point by three shears, again and again.
     *
     * @param t tan θ/2
     * @param sin sin θ
     */
    void shear(double t, double sin, int times, double[] points) {
        for (int at = 0; at < points.length; at += 2) {
            double x = points[at];
            double y = points[at + 1];
            for (int i = 0; i < times; i++) {
                double sheared = y + x * t;
                x = x - sheared * sin;
                y = x * t + sheared;
            }
            points[at] = x;
            points[at + 1] = y;
        }
    }

    /**
     * The orientation after {@code times} turns, at least 1, its length repaired in every turn: the
     * radius cannot drift, the angle still can.
     */
    Angle accumulate(Angle by, int times) {
        double c = by.cos();
        double s = by.sin();
        for (int i = 1; i < times; i++) {
            double turned = c * by.cos() - s * by.sin();
            s = c * by.sin() + s * by.cos();
            c = turned;
            // One step of Newton's for 1/√q from 1: (3 − q)/2, q being next to 1.
            double repair = 0.5 * (3 - (c * c + s * s));
            c = c * repair;
            s = s * repair;
        }
        return new Angle(s, c);
    }

    /** The angle whose half is given: cos = w² − z², sin = 2·w·z. */
    Angle twice(Angle half) {
        double zw = half.sin() * half.cos();
        return new Angle(zw + zw, (half.cos() - half.sin()) * (half.cos() + half.sin()));
    }
}
