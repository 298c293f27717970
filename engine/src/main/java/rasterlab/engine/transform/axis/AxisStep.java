package rasterlab.engine.transform.axis;

import rasterlab.engine.transform.CountingArithmetic;

/** One of the seven steps: a shift, or a turn in the plane of two coordinates. */
sealed interface AxisStep {
    /** The work of a step, for the step-by-step view. */
    String text();

    /** Does it to the point whose x stands at {@code at}. */
    void apply(double[] points, int at);

    /** Takes the same step, counted. */
    void count(CountingArithmetic on, double[] points, int at);

    /** Moves by sign times a vector. */
    record Shift(String text, double[] by, int sign) implements AxisStep {
        @Override
        public void apply(double[] points, int at) {
            for (int i = 0; i < 3; i++)
                points[at + i] = sign > 0 ? points[at + i] + by[i] : points[at + i] - by[i];
        }

        @Override
        public void count(CountingArithmetic on, double[] points, int at) {
            for (int i = 0; i < 3; i++)
                points[at + i] =
                        sign > 0 ? on.plus(points[at + i], by[i]) : on.minus(points[at + i], by[i]);
        }
    }

    /**
     * Turns coordinate {@code first} towards {@code second}, as the row {@code [first second]}
     * times {@code [cos sin; −sin cos]}.
     */
    record Turn(String text, int first, int second, double sin, double cos) implements AxisStep {
        @Override
        public void apply(double[] points, int at) {
            double a = points[at + first];
            double b = points[at + second];
            points[at + first] = a * cos - b * sin;
            points[at + second] = a * sin + b * cos;
        }

        @Override
        public void count(CountingArithmetic on, double[] points, int at) {
            double a = points[at + first];
            double b = points[at + second];
            points[at + first] = on.minus(on.times(a, cos), on.times(b, sin));
            points[at + second] = on.plus(on.times(a, sin), on.times(b, cos));
        }

        Turn back(String text) {
            return new Turn(text, first, second, -sin, cos);
        }
    }
}
