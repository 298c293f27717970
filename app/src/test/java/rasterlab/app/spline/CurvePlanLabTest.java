package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.spline.curve.CurvePlanning;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.engine.spline.plan.CurvePlan;

@Timeout(120)
class CurvePlanLabTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new ArrayList<>();
    private final CurveLabModel model = new CurveLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private CurvePlan planned(CurvePlanning planning) {
        model.plan(planning);
        thread.settle(model::settle);
        return model.state().drawings().plan().orElseThrow();
    }

    @Test
    @DisplayName("the curve is drawn by another method than the plan's, or nobody sees which")
    void curveIsDrawnByTheCheapestMethod() {
        model.sample(Sampling.flat(0.25));
        for (int times : new int[] {1, CurvePlanning.MOST_TIMES}) {
            CurvePlan plan = planned(new CurvePlanning(true, times));
            CurvePlan.MethodPolylines best = plan.chosen();
            assertEquals(times == 1 ? "uniform" : "fewest", best.method());
            assertEquals(best.method(), model.state().drawing().method());
            assertEquals(best.method(), model.state().choice().method());
            assertEquals(best.segments(), model.state().drawing().segments());
            assertEquals(best.errorPixels(), model.state().drawing().errorPixels());
        }
    }

    @Test
    @DisplayName(
            "a plan that is not asked for chooses the method, or one chosen by hand is not drawn")
    void methodChosenByHandStays() {
        CurvePlan plan = planned(new CurvePlanning(false, CurvePlanning.MOST_TIMES));
        assertEquals("fewest", plan.chosen().method());
        assertEquals("adaptive", model.state().drawing().method());
        planned(new CurvePlanning(true, CurvePlanning.MOST_TIMES));
        model.chooseMethod("adaptive-naive");
        thread.settle(model::settle);
        assertEquals("adaptive-naive", model.state().drawing().method());
        assertFalse(model.state().choice().planning().on());
    }

    @Test
    @DisplayName("the plan is not undone, or its method stays")
    void planIsPartOfTheHistory() {
        planned(new CurvePlanning(true, CurvePlanning.MOST_TIMES));
        assertEquals("fewest", model.state().choice().method());
        model.history().undo();
        thread.settle(model::settle);
        assertEquals(CurvePlanning.FIRST, model.state().choice().planning());
        assertEquals("adaptive", model.state().drawing().method());
    }

    @Test
    @DisplayName("points at given t are planned, where the flatness means nothing")
    void givenParametersHaveNoPlan() {
        planned(new CurvePlanning(true, CurvePlanning.MOST_TIMES));
        model.sample(Sampling.equal(8));
        thread.settle(model::settle);
        assertTrue(model.state().drawings().plan().isEmpty());
        assertEquals(8, model.state().drawing().segments());
        model.sample(Sampling.flat(0.25));
        thread.settle(model::settle);
        assertTrue(model.state().drawings().plan().isPresent());
    }
}
