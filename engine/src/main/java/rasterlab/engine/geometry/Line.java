package rasterlab.engine.geometry;

import rasterlab.engine.range.Finite;

/**
 * The straight line p(μ) = p₁ + μ·(p₂ − p₁) through two points.
 *
 * <p>μ &lt; 0 lies behind p₁, 0 ≤ μ ≤ 1 between the two, μ &gt; 1 beyond p₂.
 *
 * @param from p₁
 * @param through p₂, another point
 */
public record Line(Vector from, Vector through) {
    public Line {
        if (!Double.isFinite(through.x() - from.x())
                || !Double.isFinite(through.y() - from.y())
                || !Double.isFinite(through.z() - from.z()))
            throw new IllegalArgumentException(
                    "a line's points must be less than 1.8E308 apart, got "
                            + from
                            + " and "
                            + through);
        if (through.minus(from).length() == 0)
            throw new IllegalArgumentException(
                    "a line needs two different points, got " + from + " twice");
    }

    /** Where a point of the line lies. */
    public enum PositionOnLine {
        BEHIND,
        BETWEEN,
        BEYOND
    }

    /** p₂ − p₁, the direction that is called p* in the course. */
    public Vector direction() {
        return through.minus(from);
    }

    /**
     * p₁ + μ·p*, from p₂ on where that is nearer: both points are met exactly, and far from them no
     * digits cancel, as they do in (1 − μ)·p₁ + μ·p₂.
     */
    public Vector at(double mu) {
        return mu <= 0.5
                ? from.plus(direction().times(mu))
                : through.plus(direction().times(mu - 1));
    }

    /** Which part of the line μ names; both points count as between. */
    public static PositionOnLine part(double mu) {
        Finite.require("mu", mu);
        return mu < 0
                ? PositionOnLine.BEHIND
                : mu > 1 ? PositionOnLine.BEYOND : PositionOnLine.BETWEEN;
    }
}
