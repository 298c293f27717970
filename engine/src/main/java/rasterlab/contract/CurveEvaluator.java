package rasterlab.contract;

/** Computes the points of a curve at given t. */
@FunctionalInterface
public interface CurveEvaluator {
    /**
     * Sends the point at each t, in their order. It may be off by 2⁻³⁰ of the largest |coordinate|
     * among the curve's control points.
     *
     * @param t each in [0, 1]
     * @throws IllegalArgumentException if a t is not; a method may refuse, too, kinds of curves
     *     that it is not made for, a degree above 10, and with forward differences t in unequal
     *     steps. The message names the place, the value and the range
     */
    void at(Curve curve, double[] t, CurvePoints out);
}
