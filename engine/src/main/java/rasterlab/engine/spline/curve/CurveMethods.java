package rasterlab.engine.spline.curve;

import java.util.List;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.study.Method;

/** The methods that compute and draw curves, in teaching order; each is a {@link SteppedCurve}. */
final class CurveMethods {

    private CurveMethods() {}

    static List<Method<CurveTracer>> all() {
        return List.of(
                Method.failing("blending-textbook", new BlendingTextbookCurve()),
                Method.failing("matrix", new MatrixCurve()),
                Method.failing("horner", new HornerCurve()),
                Method.right("de-casteljau", new DeCasteljauCurve()),
                Method.failing("forward-differences", new ForwardDifferencesCurve()),
                Method.failing("forward-differences-float", new ForwardDifferencesFloatCurve()),
                Method.right("uniform", new UniformCurve()),
                Method.failing("adaptive-naive", new AdaptiveNaiveCurve()),
                Method.right("adaptive", new AdaptiveCurve()),
                Method.failing("curvature-unchecked", new CurvatureUncheckedCurve()),
                Method.right("fewest", new FewestCurve()));
    }
}
