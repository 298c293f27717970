package rasterlab.engine.spline;

import rasterlab.contract.Curve;

/**
 * Coefficients C = M·G once for each span, then ((a·u + b)·u + c)·u + d: n multiplications and
 * additions per coordinate.
 *
 * <p>Source: W. G. Horner, Philosophical Transactions of the Royal Society 109, 1819.
 */
public final class HornerCurve extends EvaluatedCurve {
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
}
