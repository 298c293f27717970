package rasterlab.app.exercise;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.published.PublishedSpeed;
import rasterlab.exercises.runner.Judge;
import rasterlab.exercises.runner.JudgeSettings;

/**
 * Tries a source on the open cases in isolated processes, as {@code ./lab check} does; used by one
 * thread. What that needs is prepared by the first check.
 */
final class Checking implements AutoCloseable {
    private Judge judge;

    /**
     * @param judged told the cases judged so far, on the calling thread
     * @throws InterruptedException when the thread is interrupted; the processes are ended first
     */
    Outcome outcome(Exercise exercise, String source, Consumer<List<CaseResult>> judged)
            throws InterruptedException {
        if (judge == null) judge = started();
        List<CaseResult> cases = new ArrayList<>();
        var report =
                judge.grade(
                        exercise,
                        source,
                        CaseSelection.open(),
                        done -> {
                            cases.add(CaseResult.of(exercise, done));
                            judged.accept(List.copyOf(cases));
                        });
        return Outcome.checked(exercise, source, report)
                .with(report.figures().map(one -> PublishedSpeed.of(exercise.topic(), one)));
    }

    private static Judge started() throws InterruptedException {
        try {
            return Judge.start(JudgeSettings.once());
        } catch (IllegalStateException e) {
            if (e.getCause() instanceof InterruptedException givenUp) throw givenUp;
            throw e;
        }
    }

    @Override
    public void close() {
        if (judge != null) judge.close();
    }
}
