package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.line.trace.LineTrace;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.LineWalk;
import rasterlab.engine.line.Segment;
import rasterlab.engine.line.SteppedLine;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

@Timeout(300)
class LineLabModelTest {
    private static final Segment WINDOWED =
            new Segment(-20, -3, 41, 14).in(new PixelWindow(0, 0, 20, 20));

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LineLabModel model = new LineLabModel(new LineTopic(), thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    /** Waits for the drawings and hands them to the model. */
    private void settle() {
        thread.settle(model::settle);
    }

    @Test
    void dragIsOneChangeForUndo() {
        LineChoice before = model.state().choice();
        model.beginDrag();
        for (int x = 18; x < 30; x++) model.moveEnd(End.B, x, 4);
        model.endDrag();
        assertEquals(new Segment(2, 3, 29, 4), model.state().choice().segment());
        model.history().undo();
        assertEquals(before, model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    @DisplayName("undo shows the ellipse again, and what is kept between runs is the circle")
    void modeIsThatOfTheFigureThatUndoBringsBack() {
        model.chooseMode(LineMode.ELLIPSE);
        model.chooseMode(LineMode.CIRCLE);
        model.figures().history().undo();
        assertEquals(LineMode.ELLIPSE, model.keptMode().kept());
    }

    @Test
    void pressWithoutMovingIsNoChange() {
        model.beginDrag();
        model.endDrag();
        assertFalse(model.history().undoable());
    }

    @Test
    void keysMoveAnEndAndStopAtTheLastInt() {
        model.nudgeEnd(End.A, -10, 1);
        assertEquals(new Segment(-8, 4, 17, 9), model.state().choice().segment());
        model.moveEnd(End.A, Integer.MAX_VALUE - 3, Integer.MIN_VALUE);
        model.nudgeEnd(End.A, 10, -10);
        assertEquals(Integer.MAX_VALUE, model.state().choice().segment().x0());
        assertEquals(Integer.MIN_VALUE, model.state().choice().segment().y0());
    }

    static Stream<Method<?>> methods() {
        return new LineTopic().methods().stream().map(method -> method);
    }

    @ParameterizedTest(name = "stepping back differs from replaying the walk: {0}")
    @MethodSource("methods")
    void backEqualsReplay(Method<?> method) {
        model.chooseMethod(method.name());
        model.show(new Segment(0, 0, 11, 4));
        settle();
        model.goTo(model.last());
        for (int step = model.last(); step >= model.first(); step--) {
            model.goTo(step);
            LineWalk walk = ((SteppedLine) method.implementation()).walk(0, 0, 11, 4);
            for (int i = 0; i < step; i++) assertTrue(walk.advance());
            LineDrawing drawing = model.state().drawing();
            assertEquals(walk.x(), drawing.x(step), "column at step " + step);
            assertEquals(walk.y(), drawing.y(step), "row at step " + step);
            assertEquals(walk.decision(), drawing.trace().decisions().get(step - 1));
        }
    }

    @Test
    void extraPixelsAreToldAtOnceAndMissingOnesAtTheEnd() {
        model.chooseMethod("bresenham-textbook");
        model.show(new Segment(5, 3, 5, 3));
        settle();
        LineMarks point = model.state().drawing().marks();
        assertEquals(List.of(0, 1), List.of(point.extraCount(1), point.extraCount(2)));

        model.chooseMethod("naive-textbook");
        model.show(new Segment(0, 0, 3, 13));
        settle();
        LineMarks steep = model.state().drawing().marks();
        assertEquals(0, steep.missingCount(1));
        assertEquals(10, steep.missingCount(model.last()));
    }

    @Test
    void extraPixelLitTwiceIsOneExtraPixel() {
        model.chooseMethod("bresenham-textbook");
        model.show(new Segment(5, 3, 5, 3));
        settle();
        LineDrawing drawing = model.state().drawing();
        var lit = new PixelRecording(10);
        drawing.marks().extra(drawing.pixels(), lit);
        assertEquals(drawing.difference().extra().size(), lit.size());
        assertFalse(drawing.difference().extra().contains(5, 3));
        assertTrue(drawing.difference().extra().contains(lit.x(0), lit.y(0)));
    }

    @Test
    void exactMethodHasNoWrongPixel() {
        LineMarks marks = model.state().drawing().marks();
        int last = model.last();
        assertEquals(0, marks.extraCount(last) + marks.missingCount(last));
        assertTrue(model.state().drawing().deviation().exact());
    }

    @ParameterizedTest(name = "a hazard hangs or breaks the lab: {0}")
    @MethodSource("methods")
    void showsEveryHazardWithinTheLimit(Method<?> method) {
        model.chooseMethod(method.name());
        for (var hazard : model.hazards())
            Assertions.assertTimeoutPreemptively(
                    Duration.ofMinutes(2),
                    () -> {
                        model.show(hazard.input());
                        settle();
                        assertEquals(hazard.input(), drawn());
                        assertTrue(model.last() <= LineDrawing.LIMIT, hazard.name());
                    });
    }

    @ParameterizedTest(
            name = "the lab calls right what the engine calls wrong, or the reverse: {0}")
    @MethodSource("methods")
    void judgesWindowsAsTheEngineDoes(Method<?> method) {
        model.chooseMethod(method.name());
        for (var hazard : model.hazards()) {
            if (hazard.input().isWhole()) continue;
            model.show(hazard.input());
            settle();
            assertEquals(
                    hazard.recorded().get(method.name()) == Verdict.Kind.EXACT,
                    model.state().drawing().deviation().exact(),
                    hazard.name());
        }
    }

    @Test
    void windowStaysWhileAnEndMovesUnlessTheLineIsTooLongToWait() {
        model.show(WINDOWED);
        model.moveEnd(End.B, 41, 15);
        assertEquals(WINDOWED.window(), model.state().choice().segment().window());
        model.moveEnd(End.B, Integer.MAX_VALUE, 15);
        assertTrue(model.state().choice().segment().isWhole());
    }

    @Test
    void saysHowADrawingEnded() {
        var huge = new Segment(-1_200_000_000, 0, 1_200_000_000, 7);
        assertEquals(LineTrace.TraceEnding.CUT, ending("bresenham", huge));
        assertEquals(LineTrace.TraceEnding.REFUSED, ending("dda", huge));
        assertFalse(model.state().drawing().trace().message().isEmpty());
        int last = Integer.MAX_VALUE;
        var atTheEdge = new Segment(last - 7, 5, last, 8);
        assertEquals(LineTrace.TraceEnding.ENDLESS, ending("bresenham-textbook", atTheEdge));
        assertEquals(LineTrace.TraceEnding.ENDED, ending("bresenham", atTheEdge));
    }

    private LineTrace.TraceEnding ending(String method, Segment segment) {
        model.chooseMethod(method);
        model.show(segment);
        settle();
        return model.state().drawing().trace().ending();
    }

    @Test
    void comparisonIsOffUntilAskedForAndRefusesUnknownNames() {
        assertTrue(model.state().other().isEmpty());
        model.compareWith("naive");
        settle();
        assertEquals("naive", model.state().other().orElseThrow().method());
        assertThrows(IllegalArgumentException.class, () -> model.compareWith("nobody"));
        assertEquals("naive", model.state().choice().comparison());
    }

    @Test
    void resetCanBeUndone() {
        model.show(new Segment(0, 0, 5, 5));
        model.chooseMethod("dda");
        LineChoice mine = model.state().choice();
        model.reset();
        assertEquals("bresenham", model.state().choice().method());
        model.history().undo();
        assertEquals(mine, model.state().choice());
    }

    @Test
    void listenerThatLeftHearsNothing() {
        List<LineLabState> heard = new ArrayList<>();
        Runnable leave = model.listen(heard::add);
        model.goTo(3);
        leave.run();
        model.goTo(4);
        assertEquals(1, heard.size());
        assertEquals(3, heard.get(0).step());
    }

    @Test
    void commandRepeatsWhatIsShown() {
        assertEquals(
                "echo '{\"from\": [2, 3], \"to\": [17, 9]}' | ./lab run line bresenham",
                LineCommand.of(model.state().choice()));
    }

    @Test
    void commandRepeatsTheWindowToo() {
        model.show(WINDOWED);
        assertEquals(
                "echo '{\"from\": [-20, -3], \"to\": [41, 14], \"window\": [0, 0, 20, 20]}'"
                        + " | ./lab run line bresenham",
                LineCommand.of(model.state().choice()));
    }

    /** The segment of the drawings that are shown. */
    private Segment drawn() {
        return model.state().drawings().choice().segment();
    }

    @Test
    void endFollowsTheHandBeforeAnythingIsDrawn() {
        model.moveEnd(End.B, 30, 30);
        assertEquals(new Segment(2, 3, 30, 30), model.state().choice().segment());
        assertEquals(new Segment(2, 3, 17, 9), drawn());
        settle();
        assertEquals(model.state().choice().segment(), drawn());
        assertEquals(29, model.step());
    }

    @Test
    void exactLineOfTheSameSegmentIsMadeOnce() {
        var counting = new CountingTopic();
        try (var counted = new LineLabModel(counting, thread, failures::add)) {
            counted.compareWith("naive");
            counted.settle();
            counted.chooseMethod("dda");
            counted.settle();
            assertEquals(1, counting.made.get());
        } catch (InterruptedException e) {
            throw new AssertionError("the test was interrupted", e);
        }
    }

    @Test
    void drawingsOfADragDoNotPileUp() throws InterruptedException {
        var counting = new CountingTopic();
        try (var counted = new LineLabModel(counting, thread, failures::add)) {
            counting.mayGoOn.drainPermits();
            for (int x = 100; x < 600; x++) counted.moveEnd(End.B, x, 40);
            counting.mayGoOn.release(10_000);
            counted.settle();
            assertTrue(counting.made.get() <= 4, "exact lines made: " + counting.made.get());
            thread.runAll();
            assertEquals(599, counted.state().drawings().choice().segment().x1());
        }
    }
}
