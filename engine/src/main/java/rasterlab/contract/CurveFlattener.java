package rasterlab.contract;

/** Draws a curve by a polyline that looks like it. */
@FunctionalInterface
public interface CurveFlattener {
    /**
     * Sends the corners of a polyline, at least two and however many. No point of the curve is
     * farther than {@code flatness} from the polyline, and none of the polyline from the curve. The
     * corners go along the curve: the first is that near to the curve's start, the last to its end,
     * and those between come in the order in which the curve passes them. A curve that stays in one
     * point is one segment of length 0.
     *
     * @param flatness pixels, 10⁻¹⁰⁰ to 10¹⁰⁰
     * @throws IllegalArgumentException if the flatness is outside the range, below 2⁻⁴⁰ of the
     *     curve's largest |coordinate|, or would take more than 10,000,000 segments
     */
    void flatten(Curve curve, double flatness, CurvePoints out);
}
