package rasterlab.engine.spline;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Curve;

/**
 * Coefficients C = M·G once for each span, then ((a·u + b)·u + c)·u + d: n multiplications and
 * additions per coordinate.
 *
 * <p>Source: W. G. Horner, Philosophical Transactions of the Royal Society 109, 1819.
 */
public final class HornerCurve extends EvaluatedCurve implements SteppedPoint {
    @Override
    double growth(Curve curve) {
        return PowerForm.growth(curve);
    }

    @Override
    Span span(Curve curve, int index) {
        PowerForm.requireDegree(curve);
        double[] ofX = PowerForm.coefficients(curve, curve.x(), index);
        double[] ofY = PowerForm.coefficients(curve, curve.y(), index);
        return (u, point) -> {
            double x = 0;
            double y = 0;
            for (int i = 0; i < ofX.length; i++) {
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
        Spans.requireInside(t);
        PowerForm.requireDegree(curve);
        int span = Spans.span(curve, t);
        double u = Spans.local(curve, t);
        double[] ofX = PowerForm.coefficients(curve, curve.x(), span);
        double[] ofY = PowerForm.coefficients(curve, curve.y(), span);
        var steps = new ArrayList<PointStep>();
        double x = 0;
        double y = 0;
        for (int i = 0; i < ofX.length; i++) {
            x = x * u + ofX[i];
            y = y * u + ofY[i];
            String text = i == 0 ? "C[0]" : "times u, plus C[" + i + "]";
            steps.add(PointStep.of(text, u, x, y));
        }
        return steps;
    }
}
