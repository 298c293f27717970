package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.spline.function.SplineFunctionTopic;
import rasterlab.engine.spline.function.SplineProblem;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

@Timeout(300)
class FunctionLabModelTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final FunctionLabModel model = new FunctionLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private void settle() {
        thread.settle(model::settle);
    }

    static Stream<String> methods() {
        return new SplineFunctionTopic().methods().stream().map(Method::name);
    }

    @Test
    void opensWithAnOvershootBesideNone() {
        assertTrue(model.state().drawing().worstOvershoot() > 0.05);
        assertEquals(0, model.state().drawings().other().orElseThrow().worstOvershoot());
        assertTrue(model.state().drawing().right());
    }

    @Test
    void dragIsOneChangeForUndo() {
        FunctionChoice before = model.state().choice();
        model.beginDrag();
        for (int i = 0; i < 20; i++) model.move(3, 3 + i / 50.0, 1);
        model.endDrag();
        settle();
        assertEquals(new Place(3.38, 1), model.state().choice().knots().get(3));
        model.history().undo();
        assertEquals(before, model.state().choice());
    }

    @Test
    void knotDraggedPastItsNeighbourIsRefusedAndComesBack() {
        model.move(3, 4.5, 1);
        settle();
        assertEquals(FunctionDrawing.FunctionEnding.REFUSED, model.state().drawing().ending());
        assertTrue(model.state().at().isEmpty());
        assertEquals(0, model.last());
        model.move(3, 3.5, 1);
        settle();
        assertEquals(FunctionDrawing.FunctionEnding.ENDED, model.state().drawing().ending());
        assertEquals(model.last(), model.step());
    }

    @Test
    void anAnswerThatCannotBeDrawnIsNoRefusal() {
        model.chooseMethod("cubic-textbook");
        for (Hazard<SplineProblem> hazard : model.hazards())
            if (hazard.name().equals("equal-knots")) model.show(hazard.input());
        settle();
        FunctionDrawing drawing = model.state().drawing();
        assertEquals(FunctionDrawing.FunctionEnding.UNDRAWABLE, drawing.ending());
        assertTrue(drawing.graph().isEmpty());
        assertFalse(drawing.message().isEmpty());
    }

    @ParameterizedTest(name = "ends are not kept: {0}")
    @EnumSource(SplineEnds.Kind.class)
    void graphKeepsToItsEnds(SplineEnds.Kind kind) {
        model.chooseEnds(new SplineEnds(kind, 0, 0));
        settle();
        assertEquals(FunctionDrawing.FunctionEnding.ENDED, model.state().drawing().ending());
        model.readAt(0);
        FunctionAt first = model.state().at().orElseThrow();
        model.readAt(1);
        FunctionAt last = model.state().at().orElseThrow();
        switch (kind) {
            case SLOPES -> assertEquals(0, Math.abs(first.slope()) + Math.abs(last.slope()), 1e-9);
            case NATURAL ->
                    assertEquals(0, Math.abs(first.second()) + Math.abs(last.second()), 1e-9);
            case NOT_A_KNOT -> {
                List<double[]> pieces = model.state().drawing().coefficients();
                assertEquals(pieces.get(0)[3], pieces.get(1)[3], 1e-9);
            }
            case PERIODIC -> {
                assertEquals(first.y(), last.y(), 1e-12);
                assertEquals(first.slope(), last.slope(), 1e-9);
                assertEquals(first.second(), last.second(), 1e-9);
            }
        }
    }

    @Test
    void periodicEndsMoveTogether() {
        model.chooseEnds(SplineEnds.periodic());
        int last = model.state().choice().knots().size() - 1;
        model.move(0, -0.5, 0.7);
        assertEquals(0.7, model.state().choice().knots().get(last).y());
        model.move(last, 7.5, -0.3);
        assertEquals(new Place(-0.5, -0.3), model.state().choice().knots().get(0));
        model.remove(0);
        model.add(9, 3);
        settle();
        assertEquals(FunctionDrawing.FunctionEnding.ENDED, model.state().drawing().ending());
    }

    @Test
    void slopesFollowTheirHandles() {
        model.chooseEnds(SplineEnds.slopes(0, 0));
        for (boolean left : new boolean[] {true, false}) {
            Place handle = model.slopeHandle(left);
            model.moveSlope(left, handle.y() + 0.56);
            assertEquals(handle.y() + 0.56, model.slopeHandle(left).y(), 1e-3);
        }
        assertEquals(-1, model.state().choice().ends().left(), 1e-3);
        assertEquals(1, model.state().choice().ends().right(), 1e-3);
    }

    @Test
    void knotsAreAddedInTheirPlaceAndTwoAlwaysStay() {
        model.add(2.5, 4);
        assertEquals(new Place(2.5, 4), model.state().choice().knots().get(3));
        for (int i = 0; i < 50; i++) model.remove(0);
        settle();
        assertEquals(2, model.state().choice().knots().size());
        for (int i = 0; i < 100; i++) model.add(10 + i, 1);
        settle();
        assertTrue(model.state().choice().knots().size() <= 40);
    }

    @Test
    void stepsArePlayedAndNameTheirKnot() {
        model.goTo(0);
        assertTrue(model.state().taken().isEmpty());
        model.goTo(1);
        assertEquals("eliminate", model.state().taken().orElseThrow().phase());
        model.goTo(model.last());
        assertEquals("substitute", model.state().taken().orElseThrow().phase());
        assertEquals(0, model.state().taken().orElseThrow().knot());
        model.chooseEnds(SplineEnds.notAKnot());
        settle();
        assertEquals(1, model.state().taken().orElseThrow().knot());
        model.chooseMethod("monotone");
        settle();
        assertEquals(-1, model.state().taken().orElseThrow().knot());
        assertEquals(7, model.last());
    }

    @ParameterizedTest(name = "the lab says otherwise than the engine: {0}")
    @MethodSource("methods")
    void judgesEveryHazardAsRecorded(String method) {
        model.chooseMethod(method);
        for (Hazard<SplineProblem> hazard : model.hazards()) {
            int before = model.state().arrangement();
            model.show(hazard.input());
            settle();
            FunctionDrawing drawing = model.state().drawing();
            Verdict.Kind verdict = hazard.recorded().get(method);
            String place = hazard.name() + ": " + drawing.message();
            assertEquals(
                    verdict == Verdict.Kind.REFUSED,
                    drawing.ending() == FunctionDrawing.FunctionEnding.REFUSED,
                    place);
            assertEquals(verdict == Verdict.Kind.EXACT, drawing.right(), place);
            if (hazard.input().shape())
                assertEquals(method.equals("monotone"), drawing.worstOvershoot() == 0, place);
            assertNotEquals(before, model.state().arrangement());
            assertTrue(model.everything().width() >= 0, place);
        }
    }
}
