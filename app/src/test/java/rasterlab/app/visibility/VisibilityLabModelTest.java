package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Vase;

@Timeout(30)
class VisibilityLabModelTest {
    private final ConcurrentLinkedQueue<Runnable> events = new ConcurrentLinkedQueue<>();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final List<RenderRequest> begun = new CopyOnWriteArrayList<>();
    private final Semaphore mayDraw = new Semaphore(10_000);
    private final VisibilityLabModel model =
            new VisibilityLabModel(this::draw, events::add, failures::add);

    /** Exact pictures are white; a textbook picture has one wrong pixel. */
    private Raster draw(RenderRequest request, BooleanSupplier cancelled) {
        begun.add(request);
        mayDraw.acquireUninterruptibly();
        if (cancelled.getAsBoolean()) throw new CancellationException();
        if (request.camera().rho() > 3000) throw new IllegalStateException("too far");
        var raster = new Raster(request.width(), request.height());
        raster.clear(0xFFFFFFFF);
        if (request.visibility().equals("painter-textbook")) raster.argb()[0] = 0xFFFF00FF;
        return raster;
    }

    @AfterEach
    void close() {
        mayDraw.release(10_000);
        model.close();
    }

    /** Waits for the pictures and hands their answers to the model. */
    private void settle() throws InterruptedException {
        model.settle();
        for (Runnable event = events.poll(); event != null; event = events.poll()) event.run();
    }

    @Test
    void drawsNothingBeforeItKnowsTheSize() throws InterruptedException {
        model.turn(0.1, 0);
        settle();
        assertTrue(begun.isEmpty());
        model.resize(8, 6);
        settle();
        assertEquals(8, model.state().picture().orElseThrow().raster().width());
    }

    @Test
    void framesOfADragDoNotPileUp() throws InterruptedException {
        mayDraw.drainPermits();
        model.resize(8, 6);
        for (int i = 0; i < 500; i++) model.turn(0.01, 0);
        mayDraw.release(10_000);
        settle();
        assertTrue(begun.size() <= 3, "pictures begun: " + begun.size());
        assertEquals(
                model.state().choice().camera(),
                model.state().picture().orElseThrow().request().camera());
    }

    @Test
    void countsWrongPixelsAgainstTheExactPicture() throws InterruptedException {
        model.resize(10, 10);
        model.choose(choice -> choice.withDifference(true).withVisibility("painter-textbook"));
        settle();
        var difference = model.state().difference().orElseThrow();
        assertEquals(1, difference.wrongPixels());
        assertEquals(0.01, difference.share(), 1e-12);
    }

    @Test
    void turningDropsTheDifferenceOfTheOldView() throws InterruptedException {
        model.resize(10, 10);
        model.choose(choice -> choice.withDifference(true));
        settle();
        assertTrue(model.state().difference().isPresent());
        model.turn(0.2, 0);
        assertTrue(model.state().difference().isEmpty());
    }

    @Test
    void differenceThatComesTooLateIsNotShown() throws InterruptedException {
        model.resize(10, 10);
        model.choose(choice -> choice.withDifference(true));
        model.settle();
        mayDraw.drainPermits(); // Nothing of the new view can be finished from here on.
        model.turn(0.2, 0);
        for (Runnable late = events.poll(); late != null; late = events.poll()) late.run();
        assertTrue(model.state().difference().isEmpty(), "the old view's difference came back");
    }

    @Test
    void failureOfTheRendererIsTold() throws InterruptedException {
        model.resize(4, 4);
        model.retreat(1000);
        settle();
        assertInstanceOf(IllegalStateException.class, failures.get(0));
    }

    @Test
    void anglesStayWithinOneTurn() {
        for (int i = 0; i < 100; i++) model.turn(-0.5, 0.7);
        var camera = model.state().choice().camera();
        assertTrue(camera.thetaRadians() >= 0 && camera.thetaRadians() < 2 * Math.PI);
        assertTrue(camera.phiRadians() >= 0 && camera.phiRadians() < 2 * Math.PI);
    }

    @Test
    void arrowKeysStepAsInTheCoursework() {
        double theta = model.state().choice().camera().thetaRadians();
        model.turn(Vase.THETA_STEP, 0);
        double turned = model.state().choice().camera().thetaRadians() - theta;
        assertEquals(0.03 * Math.PI, turned, 1e-12);
        assertEquals(0.05 * Math.PI, Vase.PHI_STEP);
    }

    @Test
    void wheelStaysAtDistancesThatSuitTheScene() {
        model.retreat(1e-9);
        assertEquals(0.45 * 500, model.state().choice().camera().rho(), 1e-9);
        model.retreat(1e9);
        assertEquals(8 * 500, model.state().choice().camera().rho(), 1e-9);
    }

    @Test
    void dragIsOneChangeForUndo() {
        VisibilityChoice before = model.state().choice();
        model.beginDrag();
        for (int i = 0; i < 20; i++) model.turn(0.01, 0.01);
        model.endDrag();
        model.undo();
        assertEquals(before, model.state().choice());
        assertFalse(model.state().undoable());
    }

    @Test
    void unknownNameChangesNothing() {
        VisibilityChoice before = model.state().choice();
        assertThrows(
                IllegalArgumentException.class,
                () -> model.choose(choice -> choice.withVisibility("nobody")));
        assertEquals(before, model.state().choice());
        assertFalse(model.state().undoable());
    }

    @Test
    void frameTimeNeedsThreePicturesOfTheSameMethod() throws InterruptedException {
        model.resize(4, 4);
        settle();
        assertEquals(0, model.state().medianNanos());
        for (int i = 0; i < 3; i++) {
            model.turn(0.1, 0);
            settle();
        }
        assertTrue(model.state().medianNanos() > 0);
        model.choose(choice -> choice.withVisibility("zfloat"));
        assertEquals(0, model.state().medianNanos());
    }

    @Test
    void turntableGoesRoundInTwoHundredSteps() {
        var turntable = new Turntable(model);
        turntable.goTo(50);
        assertEquals(Math.PI / 2, model.state().choice().camera().thetaRadians(), 1e-12);
        assertEquals(50, turntable.step());
        assertEquals(199, turntable.last());
    }

    @Test
    void everyHazardViewIsAPictureTheEngineAccepts() throws InterruptedException {
        model.resize(40, 30);
        for (HazardView view : HazardView.values()) {
            model.choose(view::shown);
            settle();
            assertEquals(List.of(), failures, view.code());
        }
    }
}
