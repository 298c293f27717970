package rasterlab.app.coordinates.turn;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.rotate.Turns;

@Tag("slow")
@Timeout(300)
class TurnLabModelTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final TurnLabModel model = new TurnLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    /** Waits for the answers and hands them to the model. */
    private TurnScene settled() {
        thread.settle(model::settle);
        return model.scene();
    }

    private TurnScene.Drift drift(String method) {
        return settled().drifts().stream()
                .filter(each -> each.method().equals(method))
                .findFirst()
                .orElseThrow();
    }

    @Test
    @DisplayName("the lab turns before anybody looks, or not at all")
    void beginsWithTheFirstLook() {
        assertTrue(model.busy());
        assertEquals(List.of(), settled().drifts());
        model.begin();
        assertEquals(model.methods().size(), settled().drifts().size());
        assertFalse(model.busy());
        assertEquals(21, model.last(), "seven turns of three formulas");
        assertEquals(21, model.step());
    }

    @Test
    @DisplayName("a method gets another verdict than on the command line")
    void judgesHazardsAsTheyAreRecorded() {
        for (Hazard<Turns> hazard : model.hazards()) {
            if (hazard.input().times() > 100_000) continue;
            model.show(hazard);
            for (TurnScene.Drift each : settled().drifts()) {
                Verdict.Kind recorded = hazard.recorded().get(each.method());
                String place = hazard.name() + ", " + each.method();
                assertEquals(recorded == Verdict.Kind.REFUSED, each.refused(), place);
                if (!each.refused())
                    assertEquals(recorded == Verdict.Kind.EXACT, each.right(), place);
            }
        }
    }

    @Test
    @DisplayName("float does not drift faster than double")
    void errorsGrowWithTheTurns() {
        model.turnBy(33.3);
        List<TurnScene.DriftSample> single = drift("float").samples();
        List<TurnScene.DriftSample> wide = drift("direct").samples();
        int last = single.size() - 1;
        assertEquals(TurnScene.CHARTED, single.get(last).times());
        assertTrue(single.get(last).error() > 1e4 * single.get(0).error());
        assertTrue(single.get(last).error() > 1e6 * wide.get(last).error());
    }

    @Test
    @DisplayName("the last step is not where the method ends")
    void wayEndsAtTheEnd() {
        for (var method : model.methods()) {
            model.chooseMethod(method.name());
            TurnScene scene = settled();
            TurnScene.TurnStep end = scene.steps().get(scene.steps().size() - 1);
            assertEquals(scene.drift().end().x(), end.at().x(), 1e-12, method.name());
            assertEquals(7, end.turn(), method.name());
        }
    }

    @Test
    @DisplayName("a way of ten million steps is kept")
    void longWaysAreCut() {
        model.turnTimes(1e5);
        assertEquals(3 * TurnScene.MOST_TURNS, settled().steps().size());
        model.turnTimes(0);
        assertEquals(1, model.choice().times());
        model.turnTimes(1e12);
        assertEquals(10_000_000, model.choice().times());
        assertTrue(model.busy());
        model.cancel();
        assertFalse(model.busy(), "given up, and still busy");
    }

    @Test
    @DisplayName("a refusal fails the lab")
    void refusedMethodHasNoWay() {
        model.chooseMethod("float");
        model.movePoint(3e200, 0);
        TurnScene scene = settled();
        assertTrue(scene.drift().refused());
        assertEquals(List.of(), scene.steps());
        assertTrue(model.operations().isEmpty());
        assertEquals(0, model.step());
        model.history().undo();
        assertFalse(settled().drift().refused());
    }

    @Test
    @DisplayName("Buneman's turn costs four multiplications")
    void countsTheOperationsOfATurn() {
        assertEquals(3, model.operations().get("multiplications"));
        model.chooseMethod("direct");
        assertEquals(4, model.operations().get("multiplications"));
    }
}
