package rasterlab.engine.spline.function;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.study.Deviation;

/** Many knots against the decimal reference; 10,000 of them where {@code rasterlab.full} is set. */
class SplineAccuracyTest {
    private static final SplineFunctionTopic TOPIC = new SplineFunctionTopic();
    private static final int KNOTS = Boolean.getBoolean("rasterlab.full") ? 10_000 : 1_000;

    @ParameterizedTest
    @EnumSource
    void manyKnotsStayWithinTheRounding(SplineEnds.Kind kind) {
        SplineProblem problem = SplineWorkloads.random(KNOTS, kind, new Random(8));
        SplineValues exact = TOPIC.exact(problem, Integer.MAX_VALUE);
        for (var method : RightSplines.all()) {
            SplineValues values = TOPIC.record(method.implementation(), problem, Integer.MAX_VALUE);
            Deviation deviation = TOPIC.compare(problem, exact, values);
            assertTrue(deviation.worst() <= 1e-12, method.name() + " " + deviation);
            if (Boolean.getBoolean("rasterlab.full"))
                System.out.println(kind + " " + method.name() + " " + deviation.worst());
        }
    }

    @ParameterizedTest
    @EnumSource
    void stepsGrowWithTheKnotsAndNotFaster(SplineEnds.Kind kind) {
        var method = TOPIC.method("cubic").implementation();
        long thousand =
                steps(TOPIC.operations(method, SplineWorkloads.random(1_000, kind, new Random(8))));
        long ten =
                steps(
                        TOPIC.operations(
                                method, SplineWorkloads.random(10_000, kind, new Random(8))));
        assertEquals(2 * 9_000, ten - thousand);
    }

    private static long steps(Map<String, Long> operations) {
        return operations.get("steps");
    }
}
