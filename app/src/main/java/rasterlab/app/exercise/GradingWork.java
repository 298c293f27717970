package rasterlab.app.exercise;

import static rasterlab.app.exercise.Work.Phase.GRADING;
import static rasterlab.app.exercise.Work.Phase.WAITING;

import java.util.List;
import java.util.function.Consumer;

/** Tells how a submission gets on as work that runs. */
record GradingWork(Consumer<Work> told) implements Submitting.Follower {
    @Override
    public void waits(int position) {
        told.accept(new Work(WAITING, position, 0, List.of()));
    }

    @Override
    public void judged(List<TriedCase> cases) {
        told.accept(new Work(GRADING, cases.size(), 0, cases));
    }
}
