package rasterlab.app.exercise;

import static rasterlab.app.exercise.BackgroundWork.Phase.GRADING;
import static rasterlab.app.exercise.BackgroundWork.Phase.WAITING;

import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.exercise.outcome.CaseResult;

/** Tells how a submission gets on as work that runs. */
record GradingWork(Consumer<BackgroundWork> listener) implements Submitting.SubmissionListener {
    @Override
    public void waits(int position) {
        listener.accept(new BackgroundWork(WAITING, position, 0, List.of()));
    }

    @Override
    public void judged(List<CaseResult> cases) {
        listener.accept(new BackgroundWork(GRADING, cases.size(), 0, cases));
    }
}
