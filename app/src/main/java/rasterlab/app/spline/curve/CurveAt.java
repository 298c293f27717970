package rasterlab.app.spline.curve;

import java.util.List;
import java.util.Optional;
import rasterlab.contract.Curve;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.spline.curve.CurvePlace;
import rasterlab.engine.spline.curve.DeCasteljauCurve;
import rasterlab.engine.spline.curve.PointStep;
import rasterlab.engine.spline.curve.SpanForm;

/**
 * The curve at one t: the point, how it is constructed, and the span's matrix form.
 *
 * @param curve which curve, from 0
 * @param construction de Casteljau's triangle row by row
 * @param form where the degree is low enough for powers of u
 */
public record CurveAt(
        int curve, CurvePlace place, List<PointStep> construction, Optional<SpanForm> form) {
    private static final int MOST_DEGREE = 4;

    public CurveAt {
        Bounds.requireAtLeast("curve", curve, 0);
    }

    /**
     * @param t over all curves, in [0, 1]
     */
    public static CurveAt of(List<Curve> curves, double t) {
        int index = Math.min((int) (t * curves.size()), curves.size() - 1);
        double own = Math.max(0, Math.min(1, t * curves.size() - index));
        Curve curve = curves.get(index);
        return new CurveAt(
                index,
                CurvePlace.at(curve, own),
                new DeCasteljauCurve().stepsAt(curve, own),
                curve.degree() <= MOST_DEGREE
                        ? Optional.of(SpanForm.at(curve, own))
                        : Optional.empty());
    }
}
