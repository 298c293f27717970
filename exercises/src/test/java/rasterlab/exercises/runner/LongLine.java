package rasterlab.exercises.runner;

import java.util.Map;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.topic.TopicGradings;

/** A call that draws a long line. */
final class LongLine {
    private LongLine() {}

    static GradedCall call() {
        String input = "{\"given\":{\"from\":[0,0],\"to\":[1001,500]}}";
        Case one =
                new Case(
                        "long-line",
                        Map.of(),
                        Criterion.ACCURACY,
                        Disclosure.OPEN,
                        0,
                        input,
                        false);
        return TopicGradings.named("line").calls(one, new ExerciseTolerance(true), 0).get(0);
    }
}
