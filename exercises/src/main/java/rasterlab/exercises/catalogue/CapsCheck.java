package rasterlab.exercises.catalogue;

import java.util.OptionalInt;
import java.util.function.ToLongFunction;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.child.MeasuredMethod;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Holds the limits that an exercise states against the right answers of its own cases, which must
 * not be stopped. An exercise that states none costs nothing; nor does one that was taken before.
 */
final class CapsCheck {
    private final ExerciseFolder folder;
    private final Exercise exercise;
    private final TopicGrading topic;
    private final ContractCalls contract;

    CapsCheck(ExerciseFolder folder, Exercise exercise) {
        this.folder = folder;
        this.exercise = exercise;
        this.topic = TopicGradings.of(exercise);
        this.contract = ContractCalls.of(topic.contract());
    }

    /**
     * Passes if no case has a longer right answer than the exercise takes.
     *
     * @throws CatalogueException naming the first case that has one
     */
    static void check(ExerciseFolder folder, Exercise exercise) {
        Faults faults = new Faults();
        check(folder, exercise, faults);
        faults.requireNone();
    }

    /**
     * Checks the same, where each limit that is too low is kept, with the first case that shows it.
     */
    static void check(ExerciseFolder folder, Exercise exercise, Faults faults) {
        if (exercise.form() != Exercise.TaskKind.WRITE) return;
        CapsCheck check = new CapsCheck(folder, exercise);
        Exercise.StatedLimits caps = exercise.caps();
        faults.checked(
                () ->
                        check.hold(
                                "items",
                                "field.caps.items",
                                caps.items(),
                                TopicGrading.GradedCall::items));
        faults.checked(() -> check.hold("bytes", "field.caps.bytes", caps.bytes(), check::bytes));
    }

    private void hold(
            String field,
            String key,
            OptionalInt most,
            ToLongFunction<TopicGrading.GradedCall> needed) {
        if (most.isEmpty()) return;
        for (Case one : exercise.cases())
            for (TopicGrading.GradedCall call : topic.calls(one, exercise.tolerance(), 0)) {
                long least = needed.applyAsLong(call);
                if (least > most.getAsInt())
                    throw ExerciseReader.wrong(
                            folder,
                            "caps." + field,
                            Phrase.of(key, one.name(), least, most.getAsInt()));
            }
    }

    /** Counts the bytes of the longest right answer to one call of those that an input takes. */
    private long bytes(TopicGrading.GradedCall call) {
        var right = new MeasuredMethod(contract, topic.right(), call.caps().items());
        try {
            call.recorded(right.proxy(), call.caps().items());
            return right.longest();
        } catch (LimitReached | IllegalArgumentException cutOrRefused) {
            return right.longest();
        }
    }
}
