package rasterlab.engine.transform.view;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Method;
import rasterlab.engine.transform.CountingArithmetic;

class ViewCountTest {
    private static final ViewTopic TOPIC = new ViewTopic();

    /** 8 multiplications and 5 additions, as the text says. */
    @Test
    void lectureViewTakenApartTakes13Operations() {
        Map<String, Long> counts = count("taken-apart", 1);
        assertEquals(8, counts.get("multiplications"));
        assertEquals(5, counts.get("additions"));
    }

    /** 12 multiplications; the text's 17 operations are without the addition of ρ. */
    @Test
    void lectureViewAsOneMatrixTakes17OperationsAndTheShift() {
        Map<String, Long> counts = count("one-matrix", 1);
        assertEquals(12, counts.get("multiplications"));
        assertEquals(5 + 1, counts.get("additions"));
    }

    /** The matrix is made once, so that for many points its price is 14 and not 18. */
    @Test
    void manyPointsShareThePriceOfTheMatrix() {
        assertEquals(4 + 8 * 100, count("one-matrix", 100).get("multiplications"));
        assertEquals(8 * 100, count("taken-apart", 100).get("multiplications"));
    }

    @ParameterizedTest(name = "{0} counts other work than it does")
    @ValueSource(strings = {"one-matrix", "taken-apart", "taken-apart-textbook"})
    void countingTwinGivesTheSamePoints(String name) {
        var random = new Random(17);
        var view = (CheckedView) TOPIC.method(name).implementation();
        for (int i = 0; i < 100; i++) {
            double[] points = random.doubles(6, -9, 9).toArray();
            double[] counted = points.clone();
            double theta = random.nextDouble(-400, 400);
            view.view(theta, 70, 50, points);
            view.count(new CountingArithmetic(), theta, 70, 50, counted);
            assertArrayEquals(points, counted);
        }
    }

    @Test
    void lecturePrintedStepsTakeTheOverwrittenY() {
        var printed = (SteppedView) TOPIC.method("taken-apart-textbook").implementation();
        double[] point = {1, 2, 3};
        List<ViewStep> steps = printed.steps(0, 60, 400, 1, 2, 3);
        printed.view(0, 60, 400, point);
        for (int i = 0; i < 3; i++) assertEquals(point[i], steps.get(3 + i).value());
        double overwritten = 3 * Math.sqrt(3) / 2 - 2 * 0.5;
        assertEquals(overwritten, point[1], 1e-12);
        assertEquals(400 - overwritten * Math.sqrt(3) / 2 - 3 * 0.5, point[2], 1e-12);
        assertEquals(count("taken-apart", 1), count("taken-apart-textbook", 1));
    }

    private static Map<String, Long> count(String method, int points) {
        var look = new ViewTask(20, 70, 400, new double[3 * points]);
        return TOPIC.operations(TOPIC.method(method).implementation(), look);
    }

    @Test
    void lectureSixStepsLeadToTheViewOfThePoint() {
        var view = (SteppedView) TOPIC.method("taken-apart").implementation();
        double[] point = {1, 2, 3};
        List<ViewStep> steps = view.steps(20, 70, 400, 1, 2, 3);
        view.view(20, 70, 400, point);
        assertEquals(6, steps.size());
        for (int i = 0; i < 3; i++) assertEquals(point[i], steps.get(3 + i).value());
        for (int i = 0; i < 6; i++) assertEquals(i + 1, steps.get(i).number());
        assertThrows(IllegalArgumentException.class, () -> view.steps(20, 70, -1, 1, 2, 3));
    }

    @Test
    void bothWaysAreExactOnRandomViews() {
        long seed = 400;
        var random = new Random(seed);
        for (int i = 0; i < 300; i++) {
            var look =
                    new ViewTask(
                            random.nextDouble(-720, 720),
                            random.nextDouble(-720, 720),
                            random.nextDouble(0.1, 1000),
                            random.doubles(3, -100, 100).toArray());
            for (Method<?> method : TOPIC.methods()) {
                if (!method.promisesToBeRight()) continue;
                var view = TOPIC.method(method.name()).implementation();
                Deviation deviation =
                        TOPIC.compare(look, TOPIC.exact(look, 1), TOPIC.record(view, look, 1));
                assertTrue(
                        TOPIC.correct(deviation),
                        () -> method.name() + " seed " + seed + " " + deviation);
            }
        }
    }

    @Test
    void refusesAnEyeAtTheOriginAndPointsThatAreNone() {
        for (Method<?> method : TOPIC.methods()) {
            var view = TOPIC.method(method.name()).implementation();
            for (double rho : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
                var refusal =
                        assertThrows(
                                IllegalArgumentException.class,
                                () -> view.view(0, 0, rho, new double[3]));
                assertTrue(refusal.getMessage().startsWith("rho must be above 0"));
            }
            assertThrows(
                    IllegalArgumentException.class,
                    () -> view.view(0, 0, 1, new double[] {0, Double.NaN, 0}));
            assertThrows(
                    IllegalArgumentException.class,
                    () -> view.view(Double.NaN, 0, 1, new double[3]));
        }
    }
}
