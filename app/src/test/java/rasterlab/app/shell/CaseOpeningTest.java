package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.line.LineRoom;
import rasterlab.app.line.TrialSegment;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabOpening;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.raster.Plotted;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.topic.TopicGradings;

/** Cases of exercises, as their tabs show them. */
class CaseOpeningTest {
    /** Draws the generated cases. */
    private static final long SEED = 7;

    private final LabModels models = LabModels.first(answer -> {}, CaseOpeningTest::fail);
    private final LabOpening opening =
            new LabOpening(models, work -> {}, Runnable::run, CaseOpeningTest::fail);
    private final List<String> tabs = new ArrayList<>();

    private static void fail(Throwable failure) {
        throw new AssertionError(failure);
    }

    @AfterEach
    void close() {
        models.close();
    }

    private LabOpening shown() {
        opening.showTabsBy(tabs::add);
        return opening;
    }

    @Test
    void inputOfLinesIsReadWithItsWindow() {
        shown().showInput(
                        "line",
                        "{\"from\":[1,2],\"to\":[-3,4],\"window\":[0,0,9,9]}",
                        "bresenham",
                        Optional.empty());
        assertEquals(
                new Segment(1, 2, -3, 4).in(new PixelWindow(0, 0, 9, 9)),
                models.of(new LineRoom()).state().choice().segment());
    }

    @Test
    void casesProgramIsShownBesideTheRightLine() throws InterruptedException {
        var answers = new ConcurrentLinkedQueue<Runnable>();
        var drawn = new PixelRecording(1);
        drawn.plot(1, 2);
        try (LabModels others = LabModels.first(answers::add, CaseOpeningTest::fail)) {
            new LabOpening(others, work -> {}, answers::add, CaseOpeningTest::fail)
                    .showInput(
                            "line",
                            "{\"from\":[1,2],\"to\":[3,4]}",
                            "bresenham",
                            Optional.of(new Plotted(drawn, false)));
            others.of(new LineRoom()).settle();
            answers.forEach(Runnable::run);
            TrialSegment tried = others.of(new LineRoom()).state().drawings().tried().orElseThrow();
            assertEquals(
                    new TrialSegment(
                            new Segment(1, 2, 3, 4),
                            "bresenham",
                            Optional.of(new Plotted(drawn, false))),
                    tried);
        }
    }

    @Test
    void brokenInputIsRefusedWithItsPlaceAndNoTabIsShown() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                shown().showInput(
                                                "line",
                                                "{\"from\":[1,2],\"to\":[3]}",
                                                "",
                                                Optional.empty()));
        assertTrue(refused.getMessage().contains("'to'"), refused.getMessage());
        assertEquals(List.of(), tabs);
    }

    @Test
    void casesOfEveryExerciseAreShown() {
        shown();
        for (Exercise exercise : Catalogue.builtIn().all()) {
            if (exercise.form() != Exercise.TaskKind.WRITE) continue;
            TopicGrading grading = TopicGradings.of(exercise);
            assertEquals(Optional.empty(), opening.obstacleToInputs(exercise.topic()));
            for (Exercise.Case one : exercise.cases())
                for (var call : grading.calls(one, exercise.tolerance(), SEED)) {
                    var scene = (MethodCase) SceneFile.read(call.scene());
                    tabs.clear();
                    opening.showInput(
                            scene.topic(),
                            scene.input(),
                            scene.method().orElse(""),
                            scene.plotted());
                    assertEquals(1, tabs.size(), exercise.id() + " " + one.name());
                }
        }
    }

    @Test
    void anInputInTheHazardsPlaceIsUndoneToTheHazard() {
        var rows = models.of(new LightRoom()).rows();
        rows.show("texture-mapping", "floor", "affine");
        String json = "{\"from\":[0,0,1],\"to\":[1,1,2],\"pixels\":8}";
        shown().showInput("texture-mapping", json, "affine", Optional.empty());
        assertTrue(rows.choice().hazard().startsWith("{"), rows.choice().hazard());
        rows.history().undo();
        assertEquals("floor", rows.choice().hazard());
    }

    @Test
    void anInputOfAnyOtherLabIsReadAsTheCommandLineReadsIt() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                shown().showInput(
                                                "clip-segment",
                                                "{\"window\":[0,0,1],\"segments\":[]}",
                                                "liang-barsky",
                                                Optional.empty()));
        assertTrue(refused.getMessage().contains("/window"), refused.getMessage());
        assertEquals(List.of(), tabs);
    }
}
