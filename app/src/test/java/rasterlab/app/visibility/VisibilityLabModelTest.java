package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.chart.ChartSize;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.HazardView;
import rasterlab.app.visibility.scene.SceneFiles;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Vase;

@Tag("slow")
@Timeout(300)
class VisibilityLabModelTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final List<RenderRequest> begun = new CopyOnWriteArrayList<>();
    private final Semaphore mayDraw = new Semaphore(10_000);
    private final VisibilityLabModel model =
            new VisibilityLabModel(new OwnMethods(), this::draw, thread, failures::add);

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
    private void settle() {
        thread.settle(model::settle);
    }

    @Test
    void drawsNothingBeforeItKnowsTheSize() {
        model.turn(0.1, 0);
        settle();
        assertTrue(begun.isEmpty());
        model.resize(8, 6);
        settle();
        assertEquals(8, model.state().picture().orElseThrow().raster().width());
    }

    @Test
    void framesOfADragDoNotPileUp() {
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
    void countsWrongPixelsAgainstTheExactPicture() {
        model.resize(10, 10);
        model.choose(choice -> choice.withDifference(true).withVisibility("painter-textbook"));
        settle();
        var difference = model.state().difference().orElseThrow();
        assertEquals(1, difference.wrongPixels());
        assertEquals(0.01, difference.share(), 1e-12);
    }

    @Test
    @DisplayName("after a drag nothing is counted until something is chosen")
    void endOfADragCountsWhatTheDragLeftOut() {
        model.resize(10, 10);
        model.choose(choice -> choice.withVisibility("painter-textbook"));
        model.beginDrag();
        model.turn(0.2, 0);
        settle();
        assertTrue(model.state().difference().isEmpty(), "counted while it turns");
        model.endDrag();
        settle();
        assertEquals(1, model.state().difference().orElseThrow().wrongPixels());
    }

    @Test
    @DisplayName("the end of a drag draws again what is shown already, only to count")
    void endOfADragAsksForNoPictureAgain() {
        model.resize(10, 10);
        model.beginDrag();
        model.turn(0.2, 0);
        settle();
        begun.clear();
        model.endDrag();
        settle();
        assertEquals(2, begun.size(), "the exact picture, and the method's held against it");
    }

    @Test
    void turningDropsTheDifferenceOfTheOldView() {
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
        thread.runAll();
        assertTrue(model.state().difference().isEmpty(), "the old view's difference came back");
    }

    @Test
    void failureOfTheRendererIsTold() {
        model.resize(4, 4);
        model.dolly(1000);
        settle();
        assertEquals(IllegalStateException.class, failures.get(0).getClass());
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
        model.dolly(1e-9);
        assertEquals(0.45 * 500, model.state().choice().camera().rho(), 1e-9);
        model.dolly(1e9);
        assertEquals(8 * 500, model.state().choice().camera().rho(), 1e-9);
    }

    @Test
    void dragIsOneChangeForUndo() {
        VisibilityChoice before = model.state().choice();
        model.beginDrag();
        for (int i = 0; i < 20; i++) model.turn(0.01, 0.01);
        model.endDrag();
        model.history().undo();
        assertEquals(before, model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void unknownNameChangesNothing() {
        VisibilityChoice before = model.state().choice();
        assertThrows(
                IllegalArgumentException.class,
                () -> model.choose(choice -> choice.withVisibility("nobody")));
        assertEquals(before, model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void frameTimeNeedsThreePicturesOfTheSameMethod() {
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
    void everyHazardViewIsAPictureTheEngineAccepts() {
        model.resize(40, 30);
        for (HazardView view : HazardView.values()) {
            model.choose(view::shown);
            settle();
            assertEquals(List.of(), failures, view.code());
        }
    }

    @Test
    void comparedPicturesShareTheStage() {
        model.resize(106, 40);
        model.choose(choice -> choice.withComparison("newell").withDifference(true));
        settle();
        assertEquals(50, model.state().picture().orElseThrow().raster().width());
        assertEquals(50, model.state().other().orElseThrow().raster().width());
        assertEquals("newell", model.state().other().orElseThrow().request().visibility());
        assertEquals(0, model.state().otherDifference().orElseThrow().wrongPixels());
        model.choose(choice -> choice.withComparison(""));
        settle();
        assertTrue(model.state().other().isEmpty(), "the second picture stayed");
    }

    @Test
    void stepsAreAllDrawnUntilOneIsChosen() {
        model.resize(60, 40);
        model.watchSteps(true);
        settle();
        var steps = new DrawingSteps(model);
        assertEquals(300, steps.last());
        assertEquals(300, steps.step());
        steps.goTo(7);
        settle();
        assertEquals(7, steps.step());
        model.turn(0.1, 0);
        settle();
        assertEquals(7, steps.step(), "turning lost the step");
        model.choose(choice -> choice.withVisibility("newell"));
        settle();
        assertEquals(steps.last(), steps.step(), "another method begins with its whole picture");
    }

    @Test
    void fewStepsLeaveAnEmptierPicture() {
        model.resize(60, 40);
        model.watchSteps(true);
        settle();
        model.goTo(0);
        settle();
        Raster none = model.state().picture().orElseThrow().raster();
        int background = 0xFF000000 | model.state().choice().shown().scene().backgroundRgb();
        for (int argb : none.argb()) assertEquals(background, argb);
        model.goTo(150);
        settle();
        int drawn = 0;
        for (int argb : model.state().picture().orElseThrow().raster().argb())
            if (argb != background) drawn++;
        assertTrue(drawn > 20, "drawn pixels " + drawn);
    }

    @Test
    void pixelsHistoryIsThatOfThePresentPicture() {
        model.resize(60, 40);
        model.choosePixel(new ChosenPixel(false, 500, 20));
        assertEquals(59, model.state().chosen().orElseThrow().x(), "outside goes to the edge");
        model.choosePixel(new ChosenPixel(false, 30, 20));
        settle();
        assertTrue(model.state().pixel().orElseThrow().touches().size() >= 2);
        model.turn(0.3, 0.2);
        assertTrue(model.state().pixel().isEmpty(), "the old view's history stayed");
        settle();
        assertTrue(model.state().pixel().isPresent());
        model.movePixel(1, -2);
        assertEquals(new ChosenPixel(false, 31, 18), model.state().chosen().orElseThrow());
    }

    @Test
    void methodThatRefusesSaysWhyInsteadOfFailing() {
        try (var real = new Renderer();
                var lab =
                        new VisibilityLabModel(
                                new OwnMethods(), real::render, thread, failures::add)) {
            lab.resize(30, 20);
            lab.choose(choice -> choice.withVisibility("convex").withDifference(true));
            thread.settle(lab::settle);
            String said = lab.state().picture().orElseThrow().refusal().orElseThrow();
            assertTrue(said.contains("convex closed body"), said);
            assertEquals(List.of(), failures);
        }
    }

    @Test
    void brokenFileIsToldWithItsLineAndChangesNothing(@TempDir Path folder) throws Exception {
        VisibilityChoice before = model.state().choice();
        Path broken = Files.writeString(folder.resolve("broken.obj"), "v 0 0 0\nv 1 zero 0\n");
        model.open(broken);
        settle();
        assertTrue(model.state().problem().contains("broken.obj:2"), model.state().problem());
        assertEquals(before, model.state().choice());
        Path scene = Files.writeString(folder.resolve("a.scene.json"), "{\"version\": 7}");
        model.open(scene);
        settle();
        assertTrue(model.state().problem().contains("$.version"), model.state().problem());
        model.open(folder.resolve("notes.txt"));
        settle();
        assertTrue(model.state().problem().contains("allowed are .obj"), model.state().problem());
    }

    @Test
    void savedViewComesBackWhenItIsOpened(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("mine.scene.json");
        model.choose(
                choice ->
                        choice.withScene("torus")
                                .withVisibility("warnock")
                                .withShading("phong")
                                .withProjection("isometric"));
        model.turn(0.7, 0.2);
        VisibilityChoice saved = model.state().choice();
        SceneFiles.save(file, saved);
        model.reset();
        model.open(file);
        settle();
        assertEquals("", model.state().problem());
        assertEquals(saved, model.state().choice());
    }

    @Test
    void openedModelIsShownUnderItsFilesName(@TempDir Path folder) throws Exception {
        Path file =
                Files.writeString(
                        folder.resolve("tent.obj"),
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        model.open(file);
        settle();
        assertEquals("tent.obj", model.state().choice().scene());
        assertEquals(4, model.state().choice().shown().scene().mesh().faceCount());
        assertTrue(
                VisibilityCommand.now(model).text().startsWith("./lab render " + file),
                VisibilityCommand.now(model).text());
    }

    @Test
    void countedChartIsShownAndACancelledOneIsNot() {
        model.charts().ask(asked(StageView.PRECISION, StageColors.LIGHT));
        settle();
        assertEquals(StageView.PRECISION, model.charts().chart().orElseThrow().asked().view());
        model.charts().ask(asked(StageView.GROWTH, StageColors.LIGHT));
        model.charts().cancel();
        settle();
        assertTrue(model.charts().chart().isEmpty(), "a chart that was given up is shown");
    }

    @Test
    @DisplayName("a chart keeps the colours of the theme before")
    void chartStandsOnTheGroundOfItsTheme() {
        for (var colors : List.of(StageColors.DARK, StageColors.LIGHT, StageColors.PROJECTOR)) {
            model.charts().ask(asked(StageView.PRECISION, colors));
            settle();
            var image = model.charts().chart().orElseThrow().image();
            for (int corner : new int[] {0, image.getWidth() - 1})
                assertEquals(colors.ground().getRGB(), image.getRGB(corner, 0), colors.toString());
            assertEquals(
                    colors.ground().getRGB(),
                    image.getRGB(image.getWidth() / 3, image.getHeight() / 2 + 3),
                    "the plot on " + colors);
        }
    }

    private static ChartStudies.ChartRequest asked(StageView view, StageColors colors) {
        return new ChartStudies.ChartRequest(view, Language.ENGLISH, colors, ChartSize.USUAL);
    }
}
