package rasterlab.exercises.predicting;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;

/**
 * Compares the steps that a student predicted with those that the method makes. After a wrong one
 * it goes on from the right one, so that each step is paid for alone.
 */
public final class SheetGrading {
    private final Exercise exercise;
    private final CaseSelection cases;
    private final Consumer<CaseReport> progress;

    /**
     * @param cases where the hidden ones are chosen too, the sheet must be the one of their seed
     */
    public SheetGrading(Exercise exercise, CaseSelection cases, Consumer<CaseReport> progress) {
        this.exercise = exercise;
        this.cases = cases;
        this.progress = progress;
    }

    /** The report on a sheet. */
    public Report report(String sent) {
        HandedAnswers handed;
        try {
            handed = HandedAnswers.of(exercise, sent);
        } catch (CatalogueException invalid) {
            return refused(
                    invalid.all().stream()
                            .map(one -> Message.of("in-both-languages", one.in("en"), one.in("ru")))
                            .toList());
        }
        long seed = handed.sheet().seed();
        if (cases.hidden() && seed != cases.seed())
            return refused(List.of(Message.of("predict.other-seed", seed, cases.seed())));
        List<CaseReport> judged = new ArrayList<>();
        for (Question one : handed.sheet().questions()) {
            CaseReport report =
                    judged(
                            one,
                            exercise.cases().get(one.number() - 1),
                            handed.answers().get(one.number() - 1));
            judged.add(report);
            progress.accept(report);
        }
        boolean all = judged.stream().allMatch(one -> one.verdict() == GradingVerdict.OK);
        return report(all ? GradingVerdict.OK : GradingVerdict.WRONG, judged, List.of());
    }

    private CaseReport judged(Question question, Case one, JsonNode answer) {
        boolean right = question.isRight(answer);
        String scene =
                new MethodCase(
                                exercise.topic(),
                                Optional.of(question.rules().method()),
                                question.input())
                        .write();
        return new CaseReport(
                one.name(),
                Disclosure.OPEN,
                right ? GradingVerdict.OK : GradingVerdict.WRONG,
                right ? one.points() : 0,
                one.points(),
                question.verdictMessage(answer),
                List.of(),
                scene);
    }

    private Report refused(List<Message> why) {
        List<Diagnostic> said = why.stream().map(one -> new Diagnostic(0, 0, one)).toList();
        return report(GradingVerdict.REFUSED, List.of(), said);
    }

    private Report report(
            GradingVerdict verdict, List<CaseReport> judged, List<Diagnostic> diagnostics) {
        int earned = judged.stream().mapToInt(CaseReport::points).sum();
        var points = new ScorePoints(earned, 0, 0, exercise.points().total());
        return new Report(verdict, points, judged, diagnostics, Report.PROCESS_LIMITS, 0);
    }
}
