package rasterlab.app.exercise;

import java.util.List;
import java.util.Optional;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.server.Account;
import rasterlab.exercises.Exercise;

/**
 * The state that the tab of exercises shows.
 *
 * @param source the text of the chosen exercise
 * @param otherDrafts what other windows wrote to it, and differs
 * @param outcome of the last check or submission of it
 * @param notice of the last thing that was done
 * @param unsaved why the source is not on the disk; {@link Notice#NONE} when it is
 * @param account where to submit; empty before a course is joined
 * @param joining what the last form to join a course was answered
 */
public record ExerciseState(
        Exercise exercise,
        String source,
        List<DraftFile.Other> otherDrafts,
        Optional<Outcome> outcome,
        BackgroundWork work,
        Notice notice,
        Notice unsaved,
        Optional<Account> account,
        JoinAnswer joining) {
    public ExerciseState {
        otherDrafts = List.copyOf(otherDrafts);
    }

    /** The state before anything was done. */
    static ExerciseState of(Exercise exercise, String source) {
        return new ExerciseState(
                exercise,
                source,
                List.of(),
                Optional.empty(),
                BackgroundWork.NONE,
                Notice.NONE,
                Notice.NONE,
                Optional.empty(),
                JoinAnswer.NONE);
    }

    /** Whether a server is asked to let a student join. */
    public boolean joins() {
        return work.phase() == BackgroundWork.Phase.JOINING;
    }

    /** Whether the outcome speaks of the text as it is now. */
    public boolean upToDate() {
        return outcome.filter(one -> one.source().equals(source)).isPresent();
    }
}
