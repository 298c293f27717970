package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.lab.NotShown;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.language.Language;
import rasterlab.app.line.End;
import rasterlab.app.line.LineChoice;
import rasterlab.app.line.trace.LineTrace;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.row.RowLabModel;
import rasterlab.app.shell.labs.FirstCase;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabOpening;
import rasterlab.app.shell.labs.MadeLabs;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.topic.TopicGradings;

/** A program of the user's own as a method of its topic's lab, run in a process of its own. */
@Tag("slow")
class OwnInLabTest {
    private static final Exercise LINE = Catalogue.builtIn().named("line-bresenham");

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ConcurrentLinkedQueue<Runnable> answers = new ConcurrentLinkedQueue<>();
    private final LabModels models = LabModels.first(answers::add, failures::add);
    private final List<String> tabs = new ArrayList<>();
    private final List<String> told = new ArrayList<>();
    private final LabOpening opening =
            new LabOpening(models, work -> {}, Runnable::run, failures::add);

    OwnInLabTest() {
        opening.showTabsBy(tabs::add);
        opening.tellOwnTo(
                (tab, mine) -> told.add(tab + " " + mine.exercise().id()),
                tab -> told.add(tab + " none"));
    }

    @AfterEach
    void close() {
        models.close();
        assertEquals(List.of(), failures);
    }

    private static String line(String body) {
        return "import rasterlab.contract.*;\n"
                + "public class Mine implements LineRasterizer {\n"
                + "  public void draw(int x0, int y0, int x1, int y1, Pixels out) {\n"
                + body
                + "\n  }\n}\n";
    }

    private void show(String source, String json) throws InterruptedException {
        models.own().bring(LINE, source);
        opening.showOwn("line", json, "");
        settle();
    }

    private void settle() throws InterruptedException {
        MadeLabs.line(models).settle();
        drain();
    }

    private void drain() {
        for (Runnable next = answers.poll(); next != null; next = answers.poll()) next.run();
    }

    private LineTrace trace() {
        return MadeLabs.line(models).state().drawing().trace();
    }

    @Test
    void itsPixelsAreTheStepsBesideARightMethod() throws InterruptedException {
        show(
                line("for (int x = x1; x >= x0; x--) out.plot(x, y0);"),
                "{\"from\":[1,2],\"to\":[4,2]}");
        assertEquals(
                new LineChoice(new Segment(1, 2, 4, 2), OwnMethods.NAME, "naive"),
                MadeLabs.line(models).state().choice());
        assertEquals(LineTrace.TraceEnding.ENDED, trace().ending());
        assertEquals(4, MadeLabs.line(models).state().drawing().pixels());
        assertEquals(4, MadeLabs.line(models).state().drawing().x(1));
        assertEquals(List.of("line"), tabs);
        assertEquals(List.of("line line-bresenham"), told);
    }

    @Test
    void aCaseThatTheWindowOpensWithHasTheProgramBesideTheRightMethod()
            throws InterruptedException {
        var scene = new MethodCase("line", Optional.of("dda"), "{\"from\":[1,2],\"to\":[2,2]}");
        String source = line("out.plot(x0, y0); out.plot(9, 9);");
        var own = new FirstCase.WrittenSource(LINE, source, "Mine.java");
        opening.showCase(new FirstCase(scene, Optional.of(own)));
        settle();
        assertEquals(
                new LineChoice(new Segment(1, 2, 2, 2), OwnMethods.NAME, "dda"),
                MadeLabs.line(models).state().choice());
        assertEquals(1, MadeLabs.line(models).state().drawing().difference().extra().size());
        assertEquals(List.of("line"), tabs);
        opening.showCase(new FirstCase(scene, Optional.empty()));
        settle();
        assertEquals("dda", MadeLabs.line(models).state().choice().method());
    }

    @Test
    void aWrongPixelIsMarked() throws InterruptedException {
        show(line("out.plot(x0, y0); out.plot(9, 9);"), "{\"from\":[1,2],\"to\":[2,2]}");
        var difference = MadeLabs.line(models).state().drawing().difference();
        assertEquals(1, difference.extra().size());
        assertEquals(1, difference.missing().size());
    }

    @Test
    void aDraggedEndIsDrawnByTheProgramAgain() throws InterruptedException {
        show(line("out.plot(x1, y1);"), "{\"from\":[1,2],\"to\":[4,2]}");
        MadeLabs.line(models).moveEnd(End.B, 7, 5);
        settle();
        assertEquals(7, MadeLabs.line(models).state().drawing().x(1));
    }

    @Test
    void anEndlessOneIsStoppedWithAMessageInBothLanguages() throws InterruptedException {
        show(line("while (x0 == 1) y0 += 2;"), "{\"from\":[1,2],\"to\":[4,2]}");
        assertEquals(LineTrace.TraceEnding.REFUSED, trace().ending());
        assertEquals(
                Optional.of("Your program did not answer within 2 s and was stopped"),
                OwnWords.refusal(OwnMethods.NAME, trace().message(), Language.ENGLISH));
        assertEquals(
                Optional.of("Ваша программа не ответила за 2\u00a0с и была остановлена"),
                OwnWords.refusal(OwnMethods.NAME, trace().message(), Language.RUSSIAN));
        MadeLabs.line(models).moveEnd(End.A, 0, 2);
        settle();
        assertEquals(LineTrace.TraceEnding.ENDED, trace().ending());
    }

    @Test
    void oneThatEndsItsProcessIsNotRun() throws InterruptedException {
        show(line("System.exit(1);"), "");
        assertEquals(LineTrace.TraceEnding.REFUSED, trace().ending());
        assertTrue(trace().message().contains("because of line 4"), trace().message());
    }

    @Test
    void anotherTextTakesTheOldOnesPlace() throws InterruptedException {
        show(line("out.plot(1, 1);"), "");
        show(line("out.plot(5, 5);"), "");
        assertEquals(5, MadeLabs.line(models).state().drawing().x(1));
    }

    @Test
    void withoutAProgramTheMethodSaysHowToGetOne() throws InterruptedException {
        MadeLabs.line(models).chooseMethod(OwnMethods.NAME);
        settle();
        assertEquals(LineTrace.TraceEnding.REFUSED, trace().ending());
        assertTrue(trace().message().startsWith("there is no program of yours yet"));
    }

    @Test
    void aLabWithoutMethodsOfTheContractRunsNone() {
        assertEquals(Optional.of(NotShown.NO_OWN), opening.obstacleToOwn("hidden-surfaces"));
        assertEquals(Optional.empty(), opening.obstacleToOwn("line"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"seed-fill", "polygon-fill", "point-in-polygon", "triangulate"})
    void theModelSolutionIsRightInTheLabOfPolygons(String id) throws InterruptedException {
        showModel(Catalogue.builtIn().named(id));
        MadeLabs.polygon(models).settle();
        drain();
        var results = MadeLabs.polygon(models).state().results();
        assertEquals(OwnMethods.NAME, results.outcome().method());
        assertTrue(results.outcome().isRight(), results.outcome().message());
        assertTrue(results.other().isPresent());
    }

    @ParameterizedTest
    @ValueSource(strings = {"clip-polygon", "clip-volume"})
    void theModelSolutionIsRightInTheLabOfClipping(String id) throws InterruptedException {
        showModel(Catalogue.builtIn().named(id));
        MadeLabs.clip(models).settle();
        drain();
        var clipping = MadeLabs.clip(models).state().results().clipping();
        assertEquals(OwnMethods.NAME, clipping.method());
        assertEquals("", clipping.message());
        assertEquals(0, clipping.deviation().missing() + clipping.deviation().extra());
        assertTrue(clipping.deviation().worst() < 1e-6, clipping.deviation().toString());
    }

    @ParameterizedTest
    @ValueSource(strings = {"clip-segment", "clip-polygon", "clip-volume"})
    void aClippersStepsAreWhatItSends(String id) throws InterruptedException {
        showModel(Catalogue.builtIn().named(id));
        MadeLabs.clip(models).settle();
        drain();
        var clipping = MadeLabs.clip(models).state().results().clipping();
        assertTrue(clipping.steps().size() >= clipping.parts().size(), clipping.message());
        assertTrue(clipping.parts().size() > 0, clipping.message());
    }

    @ParameterizedTest
    @ValueSource(strings = {"bezier-point", "hermite", "flatten-curve"})
    void theModelSolutionIsRightInTheLabOfCurves(String id) throws InterruptedException {
        showModel(Catalogue.builtIn().named(id));
        MadeLabs.spline(models).curve().settle();
        drain();
        var drawing = MadeLabs.spline(models).curve().state().drawing();
        assertEquals(OwnMethods.NAME, drawing.method());
        assertEquals("", drawing.message());
        assertTrue(drawing.right());
        assertTrue(drawing.segments() > 0);
    }

    @Test
    void theModelSolutionIsRightInTheLabOfFunctions() throws InterruptedException {
        showModel(Catalogue.builtIn().named("spline-function"));
        MadeLabs.spline(models).function().settle();
        drain();
        var drawing = MadeLabs.spline(models).function().state().drawing();
        assertEquals(OwnMethods.NAME, drawing.method());
        assertEquals("", drawing.message());
        assertTrue(drawing.right());
    }

    @ParameterizedTest
    @CsvSource({"texture-mapping, light", "mipmap, light", "depth-triangle, visibility"})
    void theLabsOfRowsShowTheProgram(String id, String tab) {
        Exercise exercise = Catalogue.builtIn().named(id);
        showModel(exercise);
        RowLabModel rows =
                tab.equals("light")
                        ? MadeLabs.light(models).rows()
                        : MadeLabs.visibility(models).rows();
        assertEquals(exercise.topic(), rows.choice().topic());
        assertEquals(OwnMethods.NAME, rows.choice().method());
        assertTrue(rows.open());
        assertEquals(List.of(tab), tabs);
        rows.history().undo();
        assertNotEquals(OwnMethods.NAME, rows.choice().method());
    }

    @ParameterizedTest
    @ValueSource(strings = {"view", "rotate-axis"})
    void theLabOfTransformationsTriesTheProgram(String id) {
        showModel(Catalogue.builtIn().named(id));
        var trial = MadeLabs.coordinates(models).transformations().choice().trial().orElseThrow();
        assertEquals(id, trial.topic());
        assertEquals(OwnMethods.NAME, trial.method());
        assertEquals(List.of("coordinates"), tabs);
    }

    @Test
    void theLabOfColorsAsksTheProgram() {
        showModel(Catalogue.builtIn().named("color"));
        assertTrue(
                String.valueOf(MadeLabs.light(models).kept()).contains("method=" + OwnMethods.NAME),
                String.valueOf(MadeLabs.light(models).kept()));
        assertEquals(List.of("light"), tabs);
    }

    @Test
    void theLabOfRotationsTurnsByTheProgram() {
        showModel(Catalogue.builtIn().named("cheap-rotation"));
        assertEquals(OwnMethods.NAME, MadeLabs.coordinates(models).rotation().choice().method());
        assertEquals(List.of("coordinates"), tabs);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "{\"from\":[0,0],\"to\":[9,4],\"window\":[2,1,5,3]}"})
    void aProgramForAWindowDrawsInItOrTheWholeSegment(String json) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named("window-segment");
        models.own().bring(exercise, exercise.evidence().model().orElse(OwnSources.SEGMENTS));
        opening.showOwn("line", json, "");
        settle();
        assertEquals(LineTrace.TraceEnding.ENDED, trace().ending(), trace().message());
        assertTrue(trace().pixels().size() > 0);
        var difference = MadeLabs.line(models).state().drawing().difference();
        assertEquals(0, difference.extra().size());
        assertEquals(0, difference.missing().size());
    }

    @Test
    void anEndlessClipperIsStoppedAtTheFirstSegment() throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named("clip-segment");
        models.own()
                .bring(
                        exercise,
                        """
                        import rasterlab.contract.*;
                        public class Mine implements SegmentClipper {
                            public void clip(double xmin, double ymin, double xmax, double ymax,
                                    double x0, double y0, double x1, double y1, SegmentSink out) {
                                while (xmin <= xmax) y0++;
                            }
                        }
                        """);
        opening.showOwn("clip-segment", "", "");
        MadeLabs.clip(models).settle();
        drain();
        assertEquals(
                "your program did not answer within 2.0 s and was stopped",
                MadeLabs.clip(models).state().results().clipping().message());
    }

    @ParameterizedTest
    @ValueSource(strings = {"visible-faces", "depth-order"})
    void theLabOfHiddenSurfacesDrawsByTheProgramBesideARightMethod(String id) {
        showModel(Catalogue.builtIn().named(id));
        var choice = MadeLabs.visibility(models).state().choice();
        assertEquals(OwnMethods.NAME, choice.visibility());
        assertEquals(id.equals("depth-order") ? "painter" : "back-face", choice.comparison());
        assertTrue(choice.difference());
        assertEquals(List.of("visibility"), tabs);
        MadeLabs.visibility(models).history().undo();
        assertNotEquals(OwnMethods.NAME, MadeLabs.visibility(models).state().choice().visibility());
    }

    @ParameterizedTest
    @CsvSource({
        "vertex-normals, normals=mine",
        "shade, 'shaded=shade,'",
        "shade-face, 'shaded=shade-face,'"
    })
    void theLabOfLightLightsByTheProgram(String id, String kept) {
        showModel(Catalogue.builtIn().named(id));
        assertTrue(
                String.valueOf(MadeLabs.light(models).kept()).contains(kept),
                String.valueOf(MadeLabs.light(models).kept()));
        assertEquals(List.of("light"), tabs);
        MadeLabs.light(models).history().undo();
        assertFalse(String.valueOf(MadeLabs.light(models).kept()).contains(kept));
    }

    @Test
    void noProgramOfAnotherExerciseStandsThereToBeHandedIn() throws InterruptedException {
        show(line("out.plot(1, 1);"), "{\"from\":[1,2],\"to\":[4,2]}");
        opening.showToHandIn("break-line", "line", "");
        settle();
        assertNotEquals(OwnMethods.NAME, MadeLabs.line(models).state().choice().method());
        assertEquals(new Segment(1, 2, 4, 2), MadeLabs.line(models).state().choice().segment());
        assertEquals(List.of("line line-bresenham", "line none"), told);
        assertEquals(Map.of(), models.own().shown());
    }

    @Test
    void aHazardByAnotherMethodIsNotSaidToBeTheProgram() throws InterruptedException {
        show(line("out.plot(1, 1);"), "");
        opening.showHazard("line", "upward", "dda");
        assertEquals(List.of("line line-bresenham", "line none"), told);
    }

    @Test
    void aHazardByTheProgramTellsItsExercise() throws InterruptedException {
        show(line("out.plot(1, 1);"), "");
        told.clear();
        opening.showHazard("line", "upward", OwnMethods.NAME);
        assertEquals(List.of("line line-bresenham"), told);
    }

    private void showModel(Exercise exercise) {
        models.own().bring(exercise, exercise.evidence().model().orElse(OwnSources.SEGMENTS));
        var call =
                TopicGradings.of(exercise)
                        .calls(exercise.cases().get(0), exercise.tolerance(), 7)
                        .get(0);
        var scene = (MethodCase) SceneFile.read(call.scene());
        opening.showOwn(scene.topic(), scene.input(), scene.method().orElse(""));
    }

    @Test
    void theWayBackLeadsToTheExercise() throws InterruptedException {
        show(line("out.plot(1, 1);"), "");
        models.exercises().choose("circle");
        opening.showExercise(models.own().of("line").orElseThrow().exercise());
        assertEquals(List.of("line", "exercises"), tabs);
        String chosen = String.valueOf(models.exercises().kept());
        assertTrue(chosen.contains("exercise=line-bresenham"), chosen);
    }
}
