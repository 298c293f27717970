package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.spline.curve.Joint;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.engine.spline.curve.CurveJoint;
import rasterlab.engine.spline.curve.CurveTopic;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

@Timeout(300)
class CurveLabModelTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final CurveLabModel model = new CurveLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private void settle() {
        thread.settle(model::settle);
    }

    static Stream<String> methods() {
        return new CurveTopic().methods().stream().map(Method::name);
    }

    @Test
    void opensWithAnAdaptivePolylineThatIsRight() {
        CurveDrawing drawing = model.state().drawing();
        assertTrue(drawing.right());
        assertTrue(drawing.segments() > 4, "" + drawing.segments());
        assertTrue(drawing.errorPixels() <= drawing.allowedPixels());
    }

    @Test
    @DisplayName("undo of a drag moves the view")
    void undoLeavesTheViewWhereTheChangeLeftIt() {
        int before = model.state().arrangement();
        model.move(1, 100, 44);
        model.history().undo();
        assertEquals(before, model.state().arrangement());
        model.history().redo();
        assertEquals(before, model.state().arrangement());
        settle();
    }

    @Test
    void dragIsOneChangeForUndo() {
        CurveChoice before = model.state().choice();
        model.beginDrag();
        for (int x = 100; x < 120; x++) model.move(1, x, 44);
        model.endDrag();
        assertEquals(new Place(119, 44), model.state().choice().points().get(1));
        assertTrue(model.history().undoable());
        model.history().undo();
        assertEquals(before, model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void resetCanBeUndone() {
        model.chooseForm(CurveForm.B_SPLINE);
        CurveChoice changed = model.state().choice();
        model.reset();
        assertEquals(CurveForm.BEZIER, model.state().choice().form());
        model.history().undo();
        assertEquals(changed, model.state().choice());
    }

    /** Stepping and t are one: each goes where the other is. */
    @Test
    void stepsAreTheCornersAndTheirT() {
        List<CurveDrawing.Corner> corners = model.state().drawing().points();
        for (int step = model.first(); step <= model.last(); step++) {
            model.goTo(step);
            assertEquals(step, model.step());
            assertEquals(corners.get(step).t(), model.state().t());
            assertEquals(corners.get(step).x(), model.state().at().place().x(), 1e-9);
        }
        model.goToT(7);
        assertEquals(1, model.state().t());
        assertEquals(model.last(), model.step());
        model.goTo(-3);
        assertEquals(0, model.step());
    }

    @Test
    void coarserFlatnessTakesFewerSegments() {
        model.sample(Sampling.flat(0.1));
        settle();
        int fine = model.last();
        model.sample(Sampling.flat(20));
        settle();
        assertTrue(model.last() < fine, model.last() + " and " + fine);
        model.sample(Sampling.equal(7));
        settle();
        assertEquals(7, model.last());
    }

    @ParameterizedTest(name = "points are lost: {0}")
    @EnumSource(CurveForm.class)
    void pointsAreAddedAndTakenAway(CurveForm form) {
        model.chooseForm(form);
        CurveChoice before = model.state().choice();
        model.add(333, 111);
        settle();
        CurveChoice more = model.state().choice();
        if (form == CurveForm.HERMITE) {
            assertEquals(before, more);
            return;
        }
        int added = form == CurveForm.PIECES ? 3 : 1;
        assertEquals(before.points().size() + added, more.points().size());
        assertEquals(new Place(333, 111), more.points().get(more.points().size() - 1));
        model.remove(more.points().size() - 1);
        assertEquals(before.points(), model.state().choice().points());
        for (int i = 0; i < 100; i++) model.remove(0);
        settle();
        assertFalse(model.state().choice().points().isEmpty());
    }

    @Test
    void newPieceGoesOnSmoothly() {
        model.chooseForm(CurveForm.PIECES);
        model.add(700, 300);
        settle();
        List<Joint> joints = model.state().drawings().joints();
        assertEquals(3, joints.size());
        assertTrue(
                joints.get(2).kind().compareTo(CurveJoint.Continuity.C1) >= 0, "" + joints.get(2));
    }

    @Test
    void allPiecesAreDrawnAsOne() {
        model.chooseForm(CurveForm.PIECES);
        settle();
        List<CurveDrawing.Corner> corners = model.state().drawing().points();
        for (int i = 1; i < corners.size(); i++)
            assertTrue(corners.get(i).t() > corners.get(i - 1).t(), "corner " + i);
        assertEquals(0, corners.get(0).t());
        assertEquals(1, corners.get(corners.size() - 1).t());
        model.goToT(0.5);
        assertEquals(1, model.state().at().curve());
        assertEquals(0.5, model.state().at().place().u(), 1e-9);
    }

    @Test
    void secondMethodIsDrawnBeside() {
        model.show(hazard("s-curve"));
        model.chooseMethod("adaptive-naive");
        model.compareWith("adaptive");
        settle();
        assertFalse(model.state().drawing().right());
        assertTrue(model.state().drawings().other().orElseThrow().right());
        assertThrows(IllegalArgumentException.class, () -> model.compareWith("guess"));
    }

    private CurveTask hazard(String name) {
        return model.hazards().stream()
                .filter(each -> each.name().equals(name))
                .findFirst()
                .orElseThrow()
                .input();
    }

    @ParameterizedTest(name = "the lab says otherwise than the engine: {0}")
    @MethodSource("methods")
    void judgesEveryHazardAsRecorded(String method) {
        model.chooseMethod(method);
        for (Hazard<CurveTask> hazard : model.hazards()) {
            model.show(hazard.input());
            settle();
            CurveDrawing drawing = model.state().drawing();
            Verdict.Kind verdict = hazard.recorded().get(method);
            String place = hazard.name() + ": " + drawing.message();
            assertEquals(verdict == Verdict.Kind.EXACT, drawing.right(), place);
            assertEquals(
                    verdict == Verdict.Kind.REFUSED,
                    drawing.ending() == CurveDrawing.CurveEnding.REFUSED,
                    place);
        }
    }

    @ParameterizedTest(name = "{0} has a joint that its form excludes")
    @EnumSource(
            value = CurveForm.class,
            names = {"CATMULL_ROM", "B_SPLINE"})
    void jointsAreAsSmoothAsTheFormPromises(CurveForm form) {
        model.chooseForm(form);
        settle();
        var promised =
                form == CurveForm.B_SPLINE ? CurveJoint.Continuity.C2 : CurveJoint.Continuity.C1;
        List<Joint> joints = model.state().drawings().joints();
        assertEquals(3, joints.size());
        for (Joint joint : joints) assertEquals(promised, joint.kind());
    }

    @Test
    void otherCurveIsBroughtIntoSightAndADragIsNot() {
        int before = model.state().arrangement();
        model.move(1, 5, 5);
        settle();
        assertEquals(before, model.state().arrangement());
        model.show(hazard("cusp"));
        assertNotEquals(before, model.state().arrangement());
    }
}
