package rasterlab.app.exercise.panel;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import rasterlab.app.exercise.outcome.Outcome;

/** How a window's {@link ExercisePanes} were left, for those in another language or theme. */
public final class SavedExercisePanes {
    private final Map<String, Double> shares = new HashMap<>();
    private final Map<Result, Choice> cases = new HashMap<>();
    private Optional<ExercisePanes.Room> chosen = Optional.empty();

    /**
     * @param hasOutcome whether it holds an outcome, not only cases that are to be tried
     */
    private record Result(String exercise, boolean hasOutcome) {}

    private record Choice(Optional<Outcome> outcome, String name) {
        private boolean holdsIn(Optional<Outcome> result) {
            return outcome.map(one -> result.filter(next -> next.agrees(one, name)).isPresent())
                    .orElse(result.isEmpty());
        }
    }

    /** Share of the room before the divider of that name, from 0 to 1. */
    double share(String divider, double usual) {
        return shares.getOrDefault(divider, usual);
    }

    void divide(String divider, double share) {
        shares.put(divider, share);
    }

    /** The part that was in sight last; empty before any was. */
    Optional<ExercisePanes.Room> chosen() {
        return chosen;
    }

    public void choose(ExercisePanes.Room room) {
        chosen = Optional.of(room);
    }

    /**
     * Name of the case that was chosen last in that result, or in one before that agrees with it;
     * empty before one was.
     */
    Optional<String> chosenCase(String exercise, Optional<Outcome> outcome) {
        return Optional.ofNullable(cases.get(new Result(exercise, outcome.isPresent())))
                .filter(choice -> choice.holdsIn(outcome))
                .map(Choice::name);
    }

    void chooseCase(String exercise, Optional<Outcome> outcome, String name) {
        cases.put(new Result(exercise, outcome.isPresent()), new Choice(outcome, name));
    }
}
