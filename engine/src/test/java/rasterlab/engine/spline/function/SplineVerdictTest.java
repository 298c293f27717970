package rasterlab.engine.spline.function;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.time.Duration;
import java.util.Arrays;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.Verdict.Kind;

/** Methods that answer with rubbish: the verdict is theirs and never passes for a refusal. */
class SplineVerdictTest {
    private static final SplineFunctionTopic TOPIC = new SplineFunctionTopic();
    private static final SplineFunction RIGHT = new CubicSpline();

    /** Coefficients of straight lines, which divide 0 by 0 where two knots are equal. */
    private static final SplineFunction DIVIDING =
            (x, y, ends) -> {
                var coefficients = new double[4 * (x.length - 1)];
                for (int i = 0; i < x.length - 1; i++) {
                    coefficients[4 * i] = y[i];
                    coefficients[4 * i + 1] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
                }
                return coefficients;
            };

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("rubbish")
    void isWrong(SplineFunction function, String hazard, String detail) {
        Verdict verdict = verdict(function, hazard);
        assertEquals(Kind.WRONG, verdict.kind(), verdict.detail());
        assertTrue(verdict.detail().contains(detail), verdict.detail());
    }

    static Stream<Arguments> rubbish() {
        return Stream.of(
                argumentSet(
                        "dividing by equal knots passes for a refusal",
                        DIVIDING,
                        "equal-knots",
                        "values where no spline exists"),
                argumentSet(
                        "spreading NaN passes for a refusal",
                        DIVIDING,
                        "not-a-number",
                        "values where no spline exists"),
                argumentSet(
                        "no coefficients pass for a refusal",
                        (SplineFunction) (x, y, ends) -> new double[0],
                        "single-knot",
                        "values where no spline exists"),
                argumentSet(
                        "too few coefficients pass for a refusal",
                        (SplineFunction)
                                (x, y, ends) -> Arrays.copyOf(RIGHT.coefficients(x, y, ends), 4),
                        "three-knots",
                        "4 coefficients where 8 are right"),
                argumentSet(
                        "NaN in the last piece is not seen",
                        (SplineFunction) SplineVerdictTest::spoilt,
                        "three-knots",
                        "NaN instead of"));
    }

    private static double[] spoilt(double[] x, double[] y, SplineEnds ends) {
        double[] coefficients = RIGHT.coefficients(x, y, ends);
        coefficients[coefficients.length - 1] = Double.NaN;
        return coefficients;
    }

    private static Verdict verdict(SplineFunction function, String name) {
        Hazard<SplineProblem> hazard =
                TOPIC.hazards().stream().filter(h -> h.name().equals(name)).findFirst().get();
        var method = Method.failing("own", function);
        return HazardTrial.judge(TOPIC, method, hazard, Duration.ofMinutes(2));
    }
}
