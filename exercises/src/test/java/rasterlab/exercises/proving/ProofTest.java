package rasterlab.exercises.proving;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Evidence;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;
import rasterlab.exercises.score.SpeedPoints;

/** Proving finds what speaks against an exercise. */
class ProofTest {
    private static final long SEED = 7;
    private static final Exercise TRIANGLE = Catalogue.builtIn().named("point-in-triangle");

    private static Exercise with(Stream<Case> cases, Evidence evidence) {
        return new Exercise(
                TRIANGLE.id(),
                TRIANGLE.topic(),
                TRIANGLE.contract(),
                TRIANGLE.title(),
                TRIANGLE.statement(),
                TRIANGLE.pictures(),
                TRIANGLE.starter(),
                TRIANGLE.revision(),
                TRIANGLE.tolerance(),
                TRIANGLE.points(),
                TRIANGLE.caps(),
                TRIANGLE.timed(),
                TRIANGLE.groups(),
                cases.toList(),
                TRIANGLE.breaking(),
                TRIANGLE.predicting(),
                evidence,
                OptionalInt.empty(),
                List.of());
    }

    private static List<String> keys(Proof proof) {
        return proof.faults().stream().map(one -> one.key()).toList();
    }

    @Test
    void nothingSpeaksAgainstAWholeExercise() {
        assertEquals(List.of(), keys(Proving.of(TRIANGLE, SEED)));
    }

    @Test
    @DisplayName("a mistake that no case rejects is passed over")
    void aMistakeThatPassesIsTold() {
        Exercise poor =
                with(
                        TRIANGLE.cases().stream()
                                .filter(one -> one.name().equals("inside-and-outside")),
                        TRIANGLE.evidence());
        assertEquals(Set.of("proof.passes"), Set.copyOf(keys(Proving.of(poor, SEED))));
    }

    @Test
    @DisplayName("a mistake that a case rejects may be said not to be asked for")
    void aMistakeThatIsAskedForMayNotBeListedAsNotAsked() {
        Exercise modest =
                with(
                        TRIANGLE.cases().stream(),
                        new Evidence(Optional.empty(), Set.of("side-is-outside")));
        assertEquals(List.of("proof.asked"), keys(Proving.of(modest, SEED)));
    }

    @Test
    @DisplayName("a starter that does the work is passed over")
    void aStarterThatEarnsPointsIsTold() throws InterruptedException {
        ScorePoints full = new ScorePoints(75, 15, 10, 100);
        Proof proof =
                Proving.of(
                        TRIANGLE,
                        SEED,
                        (exercise, source, cases, progress) -> report(GradingVerdict.OK, full));
        assertEquals(List.of("proof.starter"), keys(proof));
    }

    @Test
    @DisplayName("a model solution that loses points is passed over")
    void aModelThatLosesPointsIsTold() throws InterruptedException {
        Exercise own =
                with(
                        TRIANGLE.cases().stream(),
                        new Evidence(Optional.of("public class Model {}"), Set.of()));
        ScorePoints none = new ScorePoints(0, 0, 0, 100);
        Proof proof =
                Proving.of(
                        own,
                        SEED,
                        (exercise, source, cases, progress) -> report(GradingVerdict.WRONG, none));
        assertEquals(List.of("proof.model"), keys(proof));
    }

    @Test
    @DisplayName("a model solution whose speed is not measured is passed over")
    void aModelThatCannotBeTimedIsTold() throws InterruptedException {
        Exercise own =
                with(
                        TRIANGLE.cases().stream(),
                        new Evidence(Optional.of("public class Model {}"), Set.of()));
        ScorePoints slow = new ScorePoints(75, 15, 0, 100);
        Proof proof =
                Proving.of(
                        own,
                        SEED,
                        (exercise, source, cases, progress) ->
                                source.startsWith("public class Model")
                                        ? timed(slow, Message.of("speed.too-long"))
                                        : timed(new ScorePoints(0, 0, 0, 100), Message.NONE));
        assertEquals(
                List.of(
                        "exercise.json, field 'timed': the speed of the model solution cannot be"
                                + " measured: an answer is longer than what is taken while speed is"
                                + " measured"),
                proof.faults().stream().map(one -> one.in("en")).toList());
    }

    /** A report whose line on speed says why it was not measured. */
    private static Report timed(ScorePoints points, Message obstacle) {
        List<CaseReport> cases =
                List.of(
                        report(GradingVerdict.OK, points).cases().get(0),
                        SpeedPoints.none(10, obstacle));
        return new Report(GradingVerdict.WRONG, points, cases, List.of(), Report.PROCESS_LIMITS, 0);
    }

    private static Report report(GradingVerdict verdict, ScorePoints points) {
        CaseReport one =
                new CaseReport(
                        "inside-and-outside",
                        Disclosure.OPEN,
                        verdict,
                        0,
                        5,
                        Message.NONE,
                        List.of(),
                        "");
        return new Report(verdict, points, List.of(one), List.of(), Report.PROCESS_LIMITS, 0);
    }
}
