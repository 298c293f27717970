package rasterlab.exercises.runner;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Sources;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.published.PublishedReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.SpeedFigures;
import rasterlab.exercises.topic.TopicGradings;

/** A report puts a student's speed and error beside those of the topic's right methods. */
@Tag("slow")
class SpeedFiguresTest {
    @RegisterExtension static final StartedJudge JUDGE = new StartedJudge();

    @Test
    void theRightMethodsStandBesideTheStudents() throws Exception {
        Report report = JUDGE.grade(Sources.RIGHT);
        SpeedFigures figures = figures(report);
        assertEquals(report.nanosPerItem(), figures.nanos());
        assertEquals(0, figures.error());
        List<String> names =
                figures.methods().stream().map(SpeedFigures.MethodSpeed::name).toList();
        assertTrue(
                names.containsAll(List.of("naive", "dda", "bresenham", "midpoint")),
                names::toString);
        assertTrue(names.stream().noneMatch(one -> one.endsWith("-textbook")), names::toString);
        Exercise exercise = Catalogue.builtIn().named("line-bresenham");
        String json = PublishedReport.of(exercise, report, "en", (c, p) -> "").json();
        assertTrue(json.contains("\"speed\":{\"ratio\":"), json);
    }

    /** The method keeps most points without its last pixel; a missing pixel is an error of one. */
    @Test
    void theErrorIsThatOfTheStudentsOwnAnswers() throws Exception {
        Report report = JUDGE.grade(Sources.RIGHT.replace("k <= n", "k < n"));
        assertEquals(1, figures(report).error());
    }

    /** The figures of a report; a speed that a busy machine did not let be measured has none. */
    private static SpeedFigures figures(Report report) {
        assumeFalse(report.speedIsUnsettled(), "the machine is too busy");
        return report.figures().orElseThrow();
    }

    @Test
    void whatIsNotMeasuredHasNoFigures() throws Exception {
        assertEquals(Optional.empty(), JUDGE.grade(Sources.NAIVE_TEXTBOOK).figures());
    }

    static Stream<String> written() {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                .map(Exercise::id);
    }

    @ParameterizedTest(name = "{0} has no right method to stand beside, or a faulty one")
    @MethodSource("written")
    void eachExerciseHasMethodsToStandBeside(String id) {
        Exercise exercise = Catalogue.builtIn().named(id);
        TopicGrading topic = TopicGradings.of(exercise);
        List<GradedCall> calls =
                exercise.cases().stream()
                        .filter(one -> one.kind() == Criterion.ACCURACY)
                        .filter(one -> one.visibility() == Disclosure.OPEN)
                        .flatMap(one -> topic.calls(one, exercise.tolerance(), 1).stream())
                        .toList();
        TopicGrading.TimingInputs timing = topic.timings(exercise, new Random(1), List.of()).next();
        List<SpeedFigures.MethodSpeed> beside =
                new Classics().classicsFor(exercise, topic, timing, topic.right(), calls);
        assertFalse(beside.isEmpty());
        assertTrue(beside.stream().anyMatch(one -> one.error() <= 1), beside::toString);
        assertTrue(
                beside.stream().noneMatch(one -> one.name().endsWith("-textbook")),
                beside::toString);
    }
}
