package rasterlab.exercises.topic;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.util.OptionalDouble;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.document.OwnJson;

/** The largest error that a topic itself calls correct. */
final class OwnBound {
    private OwnBound() {}

    /**
     * The bound in the topic's unit; empty where an answer is right or wrong, or of any error
     * right.
     */
    static OptionalDouble of(Topic<?, ?, ?> topic) {
        if (!isCorrect(topic, Double.MIN_VALUE) || isCorrect(topic, Double.MAX_VALUE))
            return OptionalDouble.empty();
        // doubles above 0 have the order of their bits
        long correct = Double.doubleToLongBits(Double.MIN_VALUE);
        long wrong = Double.doubleToLongBits(Double.MAX_VALUE);
        while (wrong - correct > 1) {
            long middle = correct + (wrong - correct) / 2;
            if (isCorrect(topic, Double.longBitsToDouble(middle))) correct = middle;
            else wrong = middle;
        }
        return OptionalDouble.of(Double.longBitsToDouble(correct));
    }

    private static boolean isCorrect(Topic<?, ?, ?> topic, double worst) {
        return topic.correct(new Deviation(worst, 0, 0, 1, "a number differs"));
    }

    /** Whether a case holds answers to it, whatever the exercise allows. */
    static boolean isAskedFor(Case one) {
        if (one.property().isPresent()) return false;
        try {
            return OwnJson.MAPPER.readTree(one.input()).path("strict").asBoolean();
        } catch (JsonProcessingException e) {
            throw new AssertionError("a case is JSON", e);
        }
    }
}
