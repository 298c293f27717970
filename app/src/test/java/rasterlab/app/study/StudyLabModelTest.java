package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.app.study.chart.StudyWork;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.matrix.MatrixTopic;

@Tag("slow")
@Timeout(300)
class StudyLabModelTest {
    /** A topic measured in a second, where lines take ten. */
    private static final MatrixTopic SMALL = new MatrixTopic();

    private final BlockingQueue<Runnable> events = new LinkedBlockingQueue<>();
    private final BlockingQueue<Throwable> failures = new LinkedBlockingQueue<>();
    private final StudyLabModel model =
            new StudyLabModel(
                    List.of(new LineTopic(), new SegmentClipTopic(), SMALL),
                    events::add,
                    failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), List.copyOf(failures));
    }

    private StudyLabState await(Predicate<StudyLabState> wanted) throws InterruptedException {
        while (!wanted.test(model.state())) {
            Runnable event = events.poll(2, TimeUnit.MINUTES);
            if (event == null) throw new AssertionError("nothing happens: " + model.state());
            event.run();
        }
        return model.state();
    }

    private StudyLabState awaitEnd() throws InterruptedException {
        return await(state -> !state.work().running());
    }

    @Test
    void measuresEveryMethodAndTellsHowFarItIs() throws Exception {
        model.choose(SMALL.name());
        List<Integer> done = new ArrayList<>();
        model.listen(state -> done.add(state.work().done()));
        model.measure();
        var study = awaitEnd().study().orElseThrow();
        assertEquals(SMALL.name(), study.topic());
        assertEquals(
                SMALL.methods().size(),
                study.measurements().stream().map(Measurement::method).distinct().count());
        assertTrue(done.stream().anyMatch(one -> one > 0), done.toString());
    }

    @Test
    void cancelledMeasurementKeepsTheOneBefore() throws Exception {
        model.choose(SMALL.name());
        model.measure();
        var study = awaitEnd().study();
        model.takeTime(true);
        model.measure();
        model.cancel();
        assertFalse(model.state().work().running());
        assertEquals(study, model.state().study());
        model.tryHazards();
        assertFalse(awaitEnd().cells().isEmpty());
        assertEquals(study, model.state().study());
    }

    @Test
    void pointsComeWhileItIsMeasuredAndStayWhenItIsCancelled() throws Exception {
        model.takeTime(true);
        model.measure();
        StudyLabState shown = await(state -> state.work().running() && state.study().isPresent());
        assertFalse(shown.study().orElseThrow().isWhole());
        model.cancel();
        assertEquals(shown.study(), model.state().study());
    }

    @Test
    @DisplayName("the chosen point is lost when new points come")
    void chosenPointStaysThatOfItsMethodAndLevel() throws Exception {
        model.choose(SMALL.name());
        model.measure();
        Measurement chosen = awaitEnd().study().orElseThrow().measurements().get(1);
        model.choose(chosen);
        assertEquals(Optional.of(chosen), model.state().point());
        model.measure();
        Measurement anew = awaitEnd().point().orElseThrow();
        assertEquals(chosen.method(), anew.method());
        assertEquals(chosen.workload(), anew.workload());
        assertTrue(awaitEnd().study().orElseThrow().measurements().contains(anew), "of the new");
        String other =
                model.state().study().orElseThrow().measurements().stream()
                        .map(Measurement::workload)
                        .filter(one -> !one.equals(chosen.workload()))
                        .findFirst()
                        .orElseThrow();
        model.chooseLevel(other);
        assertEquals(chosen.method(), model.state().point().orElseThrow().method());
        assertEquals(Optional.of(other), model.state().shownLevel());
    }

    @Test
    @DisplayName("what was measured is gone at the next start")
    void lastResultOfATopicIsThereAtTheNextStart(@TempDir Path folder) throws Exception {
        model.keepIn(folder);
        model.choose(SMALL.name());
        model.measure();
        Study measured = awaitEnd().study().orElseThrow();
        try (var next = new StudyLabModel(List.of(SMALL), events::add, failures::add)) {
            next.keepIn(folder);
            while (next.state().study().isEmpty()) events.take().run();
            assertEquals(measured, next.state().study().orElseThrow());
            assertEquals(StudyWork.NONE, next.state().work());
        }
    }

    @Test
    @DisplayName("a result that cannot be kept counts as kept")
    void tellsThatAResultCannotBeKept(@TempDir Path folder) throws Exception {
        Path file = Files.createFile(folder.resolve("file"));
        model.choose(SMALL.name());
        model.keepIn(file);
        model.measure();
        StudyLabState ended = awaitEnd();
        assertEquals(StudyWork.Kind.NOT_KEPT, ended.work().kind());
        assertTrue(ended.work().on().contains(file.toString()), ended.work().on());
        assertTrue(ended.study().isPresent());
    }

    @Test
    @DisplayName("a measurement that was given up counts as measured, or as still running")
    void tellsThatAMeasurementWasGivenUp() throws Exception {
        model.takeTime(true);
        model.measure();
        model.cancel();
        assertEquals(StudyWork.GIVEN_UP, model.state().work());
        assertFalse(model.state().work().running());
        model.choose(model.topics().get(1).name());
        assertEquals(StudyWork.NONE, model.state().work(), "another topic");
    }

    @Test
    void triesEveryHazardAndFindsWhatIsWrittenDown() throws Exception {
        model.tryHazards();
        await(state -> !state.cells().isEmpty());
        var state = awaitEnd();
        var topic = new LineTopic();
        assertEquals(topic.hazards().size() * topic.methods().size(), state.cells().size());
        assertTrue(state.cells().stream().allMatch(cell -> cell.asRecorded()));
        var cell = state.cell("leftward", "naive-textbook").orElseThrow();
        assertEquals(Verdict.Kind.WRONG, cell.verdict().kind());
    }

    @Test
    void whatWasMeasuredOfATopicIsThereAgain() throws Exception {
        model.choose(SMALL.name());
        model.measure();
        var study = awaitEnd().study();
        model.choose("clip-segment");
        assertEquals(Optional.empty(), model.state().study());
        assertEquals(List.of(), model.state().cells());
        model.choose(SMALL.name());
        assertEquals(study, model.state().study());
    }

    @Test
    void otherTopicGivesUpWhatIsMeasured() throws Exception {
        model.measure();
        model.choose("clip-segment");
        assertFalse(model.state().work().running());
        model.tryHazards();
        var cells = awaitEnd().cells();
        assertEquals(new SegmentClipTopic().hazards().get(0).name(), cells.get(0).hazard());
        assertEquals(Optional.empty(), model.state().study());
    }

    @Test
    void choosesAPairAndItsMethod() {
        model.choose("leftward", "naive-textbook");
        assertEquals("naive-textbook", model.state().method());
        assertThrows(IllegalArgumentException.class, () -> model.choose("nowhere", "naive"));
        assertThrows(IllegalArgumentException.class, () -> model.choose("leftward", "nobody"));
        assertEquals("leftward", model.state().hazard());
    }

    @Test
    void commandDoesWhatIsShown() {
        assertEquals(
                "./lab study line --quick --out study-line.svg",
                StudyLabCommand.of(model.state(), Language.ENGLISH));
        model.takeTime(true);
        assertEquals(
                "./lab study line --lang ru --out study-line.svg",
                StudyLabCommand.of(model.state(), Language.RUSSIAN));
        model.show(StudyView.HAZARDS);
        assertEquals("./lab hazards line", StudyLabCommand.of(model.state(), Language.ENGLISH));
    }
}
