package rasterlab.contract;

/** Computes points of a curve: those at given t, or so many that a polyline looks like it. */
public interface CurveTracer {
    /**
     * Sends the point at each t, in their order.
     *
     * @param t each in [0, 1]
     * @throws IllegalArgumentException if a t is not, or the method cannot draw this curve; the
     *     message names the place, the value and the range
     */
    void at(Curve curve, double[] t, CurvePoints out);

    /**
     * Sends the corners of a polyline from the curve's start to its end. No point of the curve is
     * farther than {@code flatness} from the polyline, and none of the polyline from the curve. A
     * curve that stays in one point is one segment of length 0.
     *
     * @param flatness pixels, 10⁻¹⁰⁰ to 10¹⁰⁰
     * @throws IllegalArgumentException if the flatness is outside the range, finer than rounding
     *     allows at the curve's size, or would take more than 10,000,000 segments
     */
    void flatten(Curve curve, double flatness, CurvePoints out);
}
