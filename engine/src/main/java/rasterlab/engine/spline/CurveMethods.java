package rasterlab.engine.spline;

import java.util.List;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that compute and draw curves, in teaching order; each is a {@link SteppedCurve}. */
final class CurveMethods {
    private static final String FOLEY =
            "J. D. Foley, A. van Dam, S. K. Feiner and J. F. Hughes, Computer Graphics: Principles"
                    + " and Practice, 1990, chapter 11";
    private static final String TOO_FINE =
            "a flatness below 2⁻⁴⁰ of the largest coordinate is refused";

    private CurveMethods() {}

    static List<Method<CurveTracer>> all() {
        return List.of(
                blendingTextbook(),
                matrix(),
                horner(),
                deCasteljau(),
                forwardDifferences(),
                forwardDifferencesFloat(),
                uniform(),
                adaptiveNaive(),
                adaptive());
    }

    private static Method<CurveTracer> blendingTextbook() {
        return new Method<>(
                "blending-textbook",
                new About(
                        "(1 − t³)·P1 + 3·t·(t − 1)²·P2 + 3·t²·(1 − t)·P3 + t³·P4, as printed",
                        "the four weights should not be negative and should add up to 1",
                        "the weights anew for each point",
                        "the first weight is (1 − t)³, so Bézier curves leave their hull between the"
                                + " ends; only Hermite's are right; other kinds and degrees are"
                                + " refused",
                        "Kazantsev, course text on computer graphics, chapter 8"),
                new BlendingTextbookCurve());
    }

    private static Method<CurveTracer> matrix() {
        return new Method<>(
                "matrix",
                new About(
                        "[uⁿ … u² u 1]·M·G, weights first",
                        "the weights of points add up to 1",
                        "2·(n + 1)² multiplications for the weights, 2·(n + 1) for the point",
                        "digits cancel as the degree grows: above 10 it is refused",
                        FOLEY),
                new MatrixCurve());
    }

    private static Method<CurveTracer> horner() {
        return new Method<>(
                "horner",
                new About(
                        "((a·u + b)·u + c)·u + d with C = M·G",
                        "after j steps the value of the first j + 1 coefficients' polynomial",
                        "n multiplications and n additions per coordinate",
                        "digits cancel as the degree grows: above 10 it is refused",
                        "W. G. Horner, Philosophical Transactions of the Royal Society 109, 1819"),
                new HornerCurve());
    }

    private static Method<CurveTracer> deCasteljau() {
        return new Method<>(
                "de-casteljau",
                new About(
                        "P[i] ← (1 − u)·P[i] + u·P[i+1], n times",
                        "every row of the triangle stays in the hull of the row above",
                        "n·(n + 1)/2 means per coordinate",
                        "none known up to degree 100; " + TOO_FINE,
                        "P. de Casteljau, Outillages méthodes calcul, Citroën, 1959"),
                new DeCasteljauCurve());
    }

    private static Method<CurveTracer> forwardDifferences() {
        return new Method<>(
                "forward-differences",
                new About(
                        "Δᵏ ← Δᵏ + Δᵏ⁺¹ for k = 0 … n − 1, in doubles",
                        "after i steps Δᵏ is the difference of order k at i·h",
                        "n additions per coordinate",
                        "drifts by about steps·2⁻⁵³; t in unequal steps and degrees above 10 are"
                                + " refused",
                        FOLEY),
                new ForwardDifferencesCurve());
    }

    private static Method<CurveTracer> forwardDifferencesFloat() {
        return new Method<>(
                "forward-differences-float",
                new About(
                        "Δᵏ ← Δᵏ + Δᵏ⁺¹ for k = 0 … n − 1, in floats",
                        "after i steps Δᵏ should be the difference of order k at i·h",
                        "n additions per coordinate",
                        "drifts by about steps·2⁻²⁴ of the coordinates: pixels after thousands of"
                                + " steps",
                        FOLEY),
                new ForwardDifferencesFloatCurve());
    }

    private static Method<CurveTracer> uniform() {
        return new Method<>(
                "uniform",
                new About(
                        "n = ⌈√(d·(d − 1)·|Δ²|/(8·flatness))⌉ equal steps, points by Horner",
                        "h²/8 times the largest second derivative is within the flatness",
                        "two square roots per span, three multiplications per coordinate",
                        "none known; too many steps where only a part bends; " + TOO_FINE,
                        "G.-Z. Wang, The subdivision method for finding the intersection between"
                                + " two Bézier curves or surfaces, Zhejiang University Journal,"
                                + " 1984"),
                new UniformCurve());
    }

    private static Method<CurveTracer> adaptiveNaive() {
        return new Method<>(
                "adaptive-naive",
                new About(
                        "halve while the middle is farther from the chord's line than the flatness",
                        "passed and waiting pieces together are the curve",
                        "one triangle per test",
                        "an S-curve's middle lies on its chord, and so does that of control points"
                                + " on one line that runs beyond the ends",
                        "folklore"),
                new AdaptiveNaiveCurve());
    }

    private static Method<CurveTracer> adaptive() {
        return new Method<>(
                "adaptive",
                new About(
                        "halve while h²·max(|B″(u)|, |B″(u + h)|)/8 and the largest distance across"
                                + " the chord are above the flatness",
                        "passed and waiting pieces together are the curve, the passed ones flat",
                        "three multiplications and three additions per coordinate and halving for"
                                + " the middle and B″ there, besides the test: two square roots and"
                                + " some thirty multiplications",
                        "none known; " + TOO_FINE,
                        "J. Clark, central differencing, 1981; bound as for uniform"),
                new AdaptiveCurve());
    }
}
