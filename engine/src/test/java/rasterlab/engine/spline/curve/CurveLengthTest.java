package rasterlab.engine.spline.curve;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Verdict;

class CurveLengthTest {
    /** A find of the search for hazards: a right answer has 46,354 points, the reference 16,001. */
    @ParameterizedTest(
            name = "{0} is taken for endless where a curve is long and its flatness small")
    @ValueSource(strings = {"uniform", "de-casteljau"})
    void answerMayHaveMorePointsThanTheReference(String method) {
        var topic = new CurveTopic();
        var curve =
                new Curve(Curve.Kind.BEZIER, new double[] {0, 0, 0}, new double[] {0x1p23, 0, 0});
        Verdict verdict =
                HazardTrial.tried(
                                topic,
                                topic.method(method),
                                CurveTask.flat(curve, 0x1p-10),
                                Duration.ofMinutes(2))
                        .verdict();
        assertEquals(Verdict.Kind.EXACT, verdict.kind(), verdict.detail());
    }
}
