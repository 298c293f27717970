package rasterlab.engine.spline.curve;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Curve;

/**
 * Coefficients C = M·G once for each span, then ((a·u + b)·u + c)·u + d: n multiplications and
 * additions per coordinate.
 *
 * <p>Source: W. G. Horner, Philosophical Transactions of the Royal Society 109, 1819, pp. 308–335.
 */
public final class HornerCurve extends EvaluatedCurve implements SteppedPoint {
    @Override
    double growth(Curve curve) {
        return PowerForm.growth(curve);
    }

    @Override
    CurveSpan span(Curve curve, int index) {
        PowerForm.requireDegree(curve);
        double[] ofX = PowerForm.coefficients(curve, curve.x(), index);
        double[] ofY = PowerForm.coefficients(curve, curve.y(), index);
        return (u, point) -> {
            double x = ofX[0];
            double y = ofY[0];
            for (int i = 1; i < ofX.length; i++) {
                x = x * u + ofX[i];
                y = y * u + ofY[i];
            }
            point[0] = x;
            point[1] = y;
        };
    }

    /** One more coefficient in each step. */
    @Override
    public List<PointStep> stepsAt(Curve curve, double t) {
        CurveSpans.requireInside(t);
        PowerForm.requireDegree(curve);
        int span = CurveSpans.span(curve, t);
        double u = CurveSpans.local(curve, t);
        double[] ofX = PowerForm.coefficients(curve, curve.x(), span);
        double[] ofY = PowerForm.coefficients(curve, curve.y(), span);
        var steps = new ArrayList<PointStep>();
        double x = ofX[0];
        double y = ofY[0];
        steps.add(PointStep.of("C[0]", u, x, y));
        for (int i = 1; i < ofX.length; i++) {
            x = x * u + ofX[i];
            y = y * u + ofY[i];
            steps.add(PointStep.of("times u, plus C[" + i + "]", u, x, y));
        }
        return steps;
    }
}
