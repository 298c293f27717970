package rasterlab.app.coordinates.list;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.NO_IMAGE;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.POINTS_TOGETHER;
import static rasterlab.app.canvas.method.ShownDifference.ShownDifferenceKind.POINT_BEYOND;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.coordinates.CommandOutput;
import rasterlab.app.coordinates.figure.Mark;
import rasterlab.app.coordinates.figure.MarkBounds;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

/** Hazards of topics about points, as the lab of lists shows them. */
@Timeout(300)
class ListTrialTest {
    /** Hazards whose picture is not all of it, by some method, and in what. */
    private static final Map<String, Set<ShownDifference.ShownDifferenceKind>> UNLIKE =
            Map.of(
                    "transform at-the-eye", EnumSet.of(NO_IMAGE),
                    "transform behind-the-eye", EnumSet.of(POINTS_TOGETHER),
                    "transform close-to-the-eye", EnumSet.of(POINTS_TOGETHER),
                    "transform many-representations", EnumSet.of(POINTS_TOGETHER),
                    "transform stays-at-infinity", EnumSet.of(NO_IMAGE),
                    "transform turn-about-a-far-point", EnumSet.of(POINTS_TOGETHER),
                    "rotate-axis axis-through-far-point", EnumSet.of(POINTS_TOGETHER),
                    "view far-eye", EnumSet.of(POINTS_TOGETHER),
                    "view pole", EnumSet.of(POINTS_TOGETHER));

    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final ListLabModel model = new ListLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    @Test
    void errorsOfAllTopicsHaveARussianUnit() {
        for (String topic : new Trials().topics()) {
            model.show(model.trials().first(topic));
            var readings = new TrialReadings(model, Texts.of("coordinates.list", Language.RUSSIAN));
            assertTrue(readings.unit().matches("[^a-zA-Z]+"), topic + ": " + readings.unit());
        }
    }

    static List<Trial> trials() {
        var all = new ArrayList<Trial>();
        var trials = new Trials();
        for (String topic : trials.topics())
            for (Hazard<?> hazard : trials.hazards(topic))
                for (Method<?> method : trials.methods(topic))
                    all.add(new Trial(topic, hazard.name(), method.name()));
        return all;
    }

    /** Waits for the answer and hands it to the model. */
    private TrialScene tried(Trial trial) {
        model.show(trial);
        return settled().orElseThrow();
    }

    private Optional<TrialScene> settled() {
        thread.settle(model::settle);
        return model.trial();
    }

    @ParameterizedTest(name = "another method's answer or verdict is shown: {0}")
    @MethodSource("trials")
    void showsWhatTheMethodItselfMakes(Trial trial) {
        TrialScene scene = tried(trial);
        assertEquals(trial, scene.trial());
        assertEquals(recorded(trial), scene.verdict().kind());
        assertEquals(scene.verdict().kind() == Verdict.Kind.REFUSED, scene.made().isEmpty());
        assertEquals(scene.made().isEmpty() ? 0 : scene.size(), scene.fates().size());
        assertEquals(
                EnumSet.of(Verdict.Kind.EXACT, Verdict.Kind.REFUSED)
                        .contains(scene.verdict().kind()),
                scene.off() == 0);
    }

    private static Verdict.Kind recorded(Trial trial) {
        Hazard<?> hazard = new Trials().hazard(trial);
        return hazard.recorded().getOrDefault(trial.method(), Verdict.Kind.EXACT);
    }

    @ParameterizedTest(name = "the command has another input or method: {0}")
    @MethodSource("trials")
    void commandFindsTheSamePoints(Trial trial) throws IOException {
        TrialScene scene = tried(trial);
        String command = ListCommand.of(model);
        assertTrue(command.endsWith("./lab run " + trial.topic() + " " + trial.method()), command);
        if (scene.made().isEmpty()) return;
        JsonNode answer = CommandOutput.of(command);
        for (int i = 0; i < scene.size(); i++) {
            JsonNode point = answer.path("points").path(i);
            boolean image = point.size() == 3 && !point.path(0).isNull();
            assertEquals(scene.made().get().has(i), image, command);
            if (!image) continue;
            for (int c = 0; c < point.size(); c++)
                assertEquals(
                        scene.made().get().points()[3 * i + c], point.path(c).asDouble(), command);
        }
    }

    @Test
    @DisplayName("what the picture cannot show is not said")
    void whatThePictureCannotShowIsKnown() {
        var found = new TreeMap<String, Set<ShownDifference.ShownDifferenceKind>>();
        for (Trial trial : trials())
            for (ShownDifference each : tried(trial).differences())
                found.computeIfAbsent(
                                trial.topic() + " " + trial.hazard(),
                                name -> EnumSet.noneOf(ShownDifference.ShownDifferenceKind.class))
                        .add(each.kind());
        assertEquals(new TreeMap<>(UNLIKE), found);
    }

    @ParameterizedTest(name = "a failure is not said beside the picture: {0}")
    @MethodSource("trials")
    void noteSaysTheVerdictOnWhatFails(Trial trial) {
        TrialScene scene = tried(trial);
        for (Language language : Language.values()) {
            String note = new TrialReadings(model, texts(language)).note();
            boolean fails = scene.verdict().kind() != Verdict.Kind.EXACT;
            assertEquals(fails || !scene.differences().isEmpty(), !note.isEmpty(), note);
            if (fails) assertTrue(note.contains(trial.method()), note);
            String reason = VerdictDetail.translated(language, scene.verdict().detail());
            if (scene.verdict().kind() == Verdict.Kind.REFUSED)
                assertTrue(note.contains(reason), note);
        }
    }

    private static Texts texts(Language language) {
        return Texts.of("coordinates.list", language);
    }

    @Test
    @DisplayName("a wrong point is drawn where it belongs, or marked as right")
    void wrongPointIsDrawnBesideTheRightOne() {
        TrialScene scene = tried(new Trial("rotate-axis", "axis-along-x", "seven-steps-textbook"));
        List<Mark> marks = marks(scene);
        Mark.DotMark dot = only(marks, Mark.DotMark.class, "seven-steps-textbook");
        Mark.CrossMark cross =
                (Mark.CrossMark)
                        marks.stream().filter(m -> m instanceof Mark.CrossMark).findAny().get();
        assertTrue(Math.hypot(dot.at().x() - cross.at().x(), dot.at().y() - cross.at().y()) > 0.1);
        assertEquals("seven-steps-textbook", dot.label());
        TrialScene right = tried(new Trial("rotate-axis", "axis-along-x", "rodrigues"));
        Mark.DotMark same = only(marks(right), Mark.DotMark.class, "rodrigues");
        assertEquals("", same.label());
        assertEquals(cross.at().x(), same.at().x(), 1e-9);
    }

    private List<Mark> marks(TrialScene scene) {
        return TrialFigure.of(scene, model.choice(), Language.ENGLISH).marks();
    }

    private static <M extends Mark> M only(List<Mark> marks, Class<M> kind, String method) {
        List<M> found =
                marks.stream()
                        .filter(mark -> mark.ink().method().equals(method))
                        .flatMap(
                                mark ->
                                        kind.isInstance(mark)
                                                ? Stream.of(kind.cast(mark))
                                                : Stream.empty())
                        .toList();
        assertEquals(1, found.size(), found.toString());
        return found.get(0);
    }

    @Test
    @DisplayName("a point that a method loses is not marked")
    void missingPointHasARing() {
        Trial lost =
                trials().stream()
                        .filter(each -> tried(each).fates().contains(TrialScene.Fate.MISSING))
                        .findFirst()
                        .orElseThrow();
        assertTrue(
                marks(tried(lost)).stream()
                        .anyMatch(
                                mark ->
                                        mark instanceof Mark.WrongMark wrong
                                                && wrong.kind() == PixelMark.MISSING));
    }

    @Test
    @DisplayName("a method that is chosen later is not tried")
    void anotherMethodIsTriedOnTheSameHazard() {
        tried(new Trial("transform", "beyond-float", "double"));
        model.tryMethod("float");
        TrialScene scene = settled().orElseThrow();
        assertEquals("float", scene.trial().method());
        assertEquals(Verdict.Kind.REFUSED, scene.verdict().kind());
        model.history().undo();
        assertEquals("double", settled().orElseThrow().trial().method());
        model.history().redo();
        assertEquals("float", settled().orElseThrow().trial().method());
    }

    @Test
    @DisplayName("a late answer comes to another hazard")
    void answerToAnEarlierHazardIsDropped() throws InterruptedException {
        model.show(new Trial("view", "pole", "one-matrix"));
        model.settle();
        model.show(new Trial("view", "far-eye", "one-matrix"));
        thread.runOne();
        assertEquals(Optional.empty(), model.trial());
        assertEquals("far-eye", settled().orElseThrow().trial().hazard());
    }

    @Test
    @DisplayName("a changed list is still judged as the hazard")
    void changeOfTheListEndsTheTrial() {
        Trial trial = new Trial("transform", "flattened", "double");
        List<Runnable> changes =
                List.of(
                        () -> model.add("SCALE3DX"),
                        model::remove,
                        () -> model.move(-1),
                        () -> model.set(0, 7),
                        () -> model.choose(Subject.HOUSE),
                        () -> model.show(Example.AXIS),
                        () -> model.show(model.hazards().get(0)),
                        model::endTrial,
                        model::reset);
        for (Runnable change : changes) {
            tried(trial);
            change.run();
            assertEquals(Optional.empty(), model.choice().trial());
            assertEquals(Optional.empty(), settled());
            model.history().undo();
            assertEquals(trial, settled().orElseThrow().trial());
        }
    }

    @Test
    @DisplayName("looking from elsewhere ends the trial")
    void lookingKeepsTheTrial() {
        Trial trial = new Trial("transform", "flattened", "double");
        TrialScene scene = tried(trial);
        model.turnBy(10, 5);
        model.select(0);
        model.read(Reading.FRAME);
        model.goTo(1);
        assertEquals(Optional.of(trial), model.choice().trial());
        assertEquals(Optional.of(scene), model.trial());
    }

    @Test
    @DisplayName("the way to the end passes for the method's")
    void stepsOnTheWayAreSaidToBeTheLabs() {
        tried(new Trial("transform", "turn-about-a-far-point", "float"));
        model.goTo(2);
        assertEquals(Optional.empty(), model.shownTrial());
        String note = new TrialReadings(model, texts(Language.ENGLISH)).note();
        assertTrue(note.contains("own formula"), note);
        model.goTo(0);
        assertEquals("", new TrialReadings(model, texts(Language.ENGLISH)).note());
    }

    @Test
    @DisplayName("numbers are those of another point or row")
    void tableHasGivenExactMethodAndError() {
        tried(new Trial("transform", "behind-the-eye", "divide-first-textbook"));
        var readings = new TrialReadings(model, texts(Language.ENGLISH));
        assertEquals(List.of("", "x", "y", "z", "H"), readings.headings());
        assertEquals(
                List.of(
                        List.of("point 1", "3", "4", "1024"),
                        List.of("exact", "−3", "−4", "−1024", "−1"),
                        List.of("method", "−3", "−4", "−1024", "1"),
                        List.of("error", "0", "0", "0", "2")),
                readings.rows());
        assertEquals("1 of 1", readings.off());
        assertEquals("2", readings.error());
        assertEquals("wrong", readings.verdict());
    }

    @Test
    @DisplayName("another list than the hazard's is kept as one")
    void keptTrialMustBeTheHazards() {
        tried(new Trial("view", "pole", "one-matrix"));
        ListChoice choice = model.choice();
        ListChoice moved =
                new ListChoice(
                        choice.subject(),
                        List.of(9.0, 9.0, 9.0),
                        choice.items(),
                        0,
                        choice.reading(),
                        choice.method(),
                        choice.viewpoint(),
                        choice.trial());
        var refused = assertThrows(IllegalArgumentException.class, () -> model.restore(moved));
        assertTrue(refused.getMessage().contains("'pole'"), refused.getMessage());
        assertEquals(choice, model.choice());
    }

    @Test
    @DisplayName("given points are moved")
    void givenPointsAreTheHazards() {
        TrialScene scene = tried(new Trial("view", "pole", "taken-apart"));
        assertArrayEquals(new double[] {1, 2, 3}, Arrays.copyOf(scene.given(), 3));
    }

    @Test
    @DisplayName("points seen apart are said to lie on each other")
    void hiddenPointsAreCountedAmongTheWrongOnes() {
        TrialScene scene =
                tried(new Trial("rotate-axis", "axis-through-far-point", "seven-steps-textbook"));
        assertEquals(2, scene.off());
        assertEquals(List.of(ShownDifference.of(POINTS_TOGETHER, 1L, 2)), scene.differences());
        String note = new TrialReadings(model, texts(Language.ENGLISH)).note();
        assertTrue(note.contains("1 of 2 wrong points"), note);
    }

    @Test
    @DisplayName("a point far away makes the others one")
    void pointThatIsFarAwayIsLeftOutAndSaidToBe() {
        var near = new TrialScene.TrialPoints(new double[] {1, 2, 3}, Optional.empty());
        var far = new TrialScene.TrialPoints(new double[] {1, 2, 3e5}, Optional.empty());
        var scene =
                new TrialScene(
                        new Trial("view", "pole", "one-matrix"),
                        near.points(),
                        near,
                        Optional.of(far),
                        List.of(TrialScene.Fate.WRONG),
                        new Verdict(Verdict.Kind.WRONG, Deviation.NONE, ""));
        assertEquals(List.of(ShownDifference.of(POINT_BEYOND)), scene.differences());
        model.show(Example.AXIS);
        assertTrue(MarkBounds.around(marks(scene)).getHeight() < 100);
    }
}
