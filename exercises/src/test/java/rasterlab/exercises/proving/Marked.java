package rasterlab.exercises.proving;

import java.util.List;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.marking.Marking;

/** Marks methods of this program on all cases of an exercise. */
public final class Marked {
    private Marked() {}

    /**
     * All that came of the cases, and what they pay.
     *
     * @param method of the topic's contract
     * @param seed draws the generated cases
     */
    public static Marking cases(Exercise exercise, TopicGrading grading, Object method, long seed) {
        return on(exercise, exercise.cases(), grading, method, seed).marking;
    }

    /**
     * Tries a method on some of the exercise's cases.
     *
     * @param method of the topic's contract
     * @param seed draws the generated cases
     */
    public static GradedMethod on(
            Exercise exercise, List<Case> cases, TopicGrading grading, Object method, long seed) {
        return GradedMethod.on(
                exercise, GradedMethod.calls(exercise, cases, grading, seed), method);
    }
}
