package rasterlab.app.exercise;

import java.util.List;
import java.util.Optional;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.server.Account;
import rasterlab.exercises.Exercise;

/** The next state, of which only what changes is named. */
final class ExerciseStateChange {
    private Exercise exercise;
    private String source;
    private List<DraftFile.Other> otherDrafts;
    private Optional<Outcome> outcome;
    private BackgroundWork work;
    private Notice notice;
    private Notice unsaved;
    private Optional<Account> account;
    private JoinAnswer joining;

    ExerciseStateChange(ExerciseState from) {
        exercise = from.exercise();
        source = from.source();
        otherDrafts = from.otherDrafts();
        outcome = from.outcome();
        work = from.work();
        notice = from.notice();
        unsaved = from.unsaved();
        account = from.account();
        joining = from.joining();
    }

    ExerciseStateChange exercise(Exercise next, String itsSource) {
        exercise = next;
        source = itsSource;
        return this;
    }

    ExerciseStateChange source(String next) {
        source = next;
        return this;
    }

    ExerciseStateChange otherDrafts(List<DraftFile.Other> next) {
        otherDrafts = next;
        return this;
    }

    ExerciseStateChange outcome(Optional<Outcome> next) {
        outcome = next;
        return this;
    }

    ExerciseStateChange work(BackgroundWork next) {
        work = next;
        return this;
    }

    ExerciseStateChange notice(Notice next) {
        notice = next;
        return this;
    }

    ExerciseStateChange unsaved(Notice next) {
        unsaved = next;
        return this;
    }

    ExerciseStateChange account(Optional<Account> next) {
        account = next;
        return this;
    }

    ExerciseStateChange joining(JoinAnswer next) {
        joining = next;
        return this;
    }

    ExerciseState made() {
        return new ExerciseState(
                exercise, source, otherDrafts, outcome, work, notice, unsaved, account, joining);
    }
}
