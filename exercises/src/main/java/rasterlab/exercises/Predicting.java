package rasterlab.exercises;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The rules for steps of a method that a student predicts.
 *
 * @param method of the exercise's topic, whose recorded steps are asked for
 * @param question what each step asks, by language code
 * @param steps asked for in all
 * @param shown the first steps of each walk that are shown and not asked for
 * @param least steps asked for in one walk; shorter walks are passed over
 * @param most steps asked for in one walk; the rest of a longer one is left out
 * @param givenFields fields of a step that stand in its question
 * @param asked fields of a step that are the answer
 * @param tolerance the largest error of a number in an answer that is right
 * @param unit of that error, as it is said behind the number, by language code; none where the
 *     numbers asked for have none
 * @param inputs how inputs are drawn, as JSON
 */
public record Predicting(
        String method,
        Map<String, String> question,
        int steps,
        int shown,
        int least,
        int most,
        List<String> givenFields,
        List<PredictedField> asked,
        double tolerance,
        Map<String, String> unit,
        DecisionValue reason,
        String inputs) {
    /** The bounds of {@link #steps}. */
    public static final int FEWEST_STEPS = 10;

    public static final int MOST_STEPS = 20;

    public Predicting {
        question = Map.copyOf(question);
        givenFields = List.copyOf(givenFields);
        unit = Map.copyOf(unit);
        asked = List.copyOf(asked);
    }

    /** The question in that language, or the English one. */
    public String question(String language) {
        return question.getOrDefault(language, question.get("en"));
    }

    /** The name of the case that a step is. */
    public static String step(int number) {
        return "step-" + number;
    }

    /**
     * A field of a step that is to be predicted.
     *
     * @param words that it may have; none where it is no word
     */
    public record PredictedField(String field, List<String> words) {
        public PredictedField {
            words = List.copyOf(words);
        }
    }

    /**
     * The value by which the method decides on a step.
     *
     * @param before whether the step before it has the value, and not the step itself
     * @param field of that step; empty where the words say it all
     * @param words what the value is and what it decides, by language code
     */
    public record DecisionValue(boolean before, Optional<String> field, Map<String, String> words) {
        public DecisionValue {
            words = Map.copyOf(words);
        }

        /** The words in that language, or the English ones. */
        public String words(String language) {
            return words.getOrDefault(language, words.get("en"));
        }
    }
}
