package rasterlab.engine.scene.shape;

/**
 * The values of a parameter.
 *
 * @param round whether it is an angle that goes once round, so that both ends are one place
 */
public record Span(double from, double to, boolean round) {
    private static final double TURN = 2 * Math.PI;

    /** The angles from 0 to 2π. */
    static Span turn() {
        return new Span(0, TURN, true);
    }

    /** The direction with 2π as 0, so that both sides of a seam are bit-equal. */
    static double direction(double angle) {
        return angle == TURN ? 0 : angle;
    }

    /** The angle of (x, y) as a share of a turn, from 0 to 1. */
    static double share(double x, double y) {
        double share = Math.atan2(y, x) / TURN;
        return share < 0 ? share + 1 : share;
    }

    /**
     * Value k of 0 to {@code steps}; both ends are hit exactly. Where the span is no full turn, the
     * upper half is counted from the end, so two patches that share a side share its points.
     */
    double at(int k, int steps) {
        if (k == steps) return to;
        boolean fromEnd = !round && 2L * k > steps;
        return fromEnd ? to - (to - from) * (steps - k) / steps : from + (to - from) * k / steps;
    }

    /** The middle between values k and {@code next}. */
    double between(int k, int next, int steps) {
        return from + (to - from) * ((k + next) / 2.0) / steps;
    }

    /** 0 at the beginning, 1 at the end. */
    double share(double value) {
        return (value - from) / (to - from);
    }
}
