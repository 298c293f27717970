package rasterlab.exercises.predicting;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import rasterlab.engine.format.InvalidInput;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.judging.InputTemplate;
import rasterlab.exercises.judging.Walk;
import rasterlab.exercises.score.Phrase;

/**
 * The questions that a seed draws for an exercise: walks of its method on inputs of its template,
 * until there are as many steps as it asks for.
 *
 * @param seed the same draws the same questions
 * @param questions in order
 */
public record Sheet(long seed, List<Question> questions) {
    /** A seed is a whole number that all programs that read JSON keep as it is. */
    public static final long MOST_SEED = (1L << 53) - 1;

    /** Inputs that are drawn before an exercise is taken for one that has too few steps. */
    private static final int MOST_INPUTS = 2000;

    public Sheet {
        questions = List.copyOf(questions);
    }

    /**
     * Draws the questions.
     *
     * @param topic of the method
     * @throws CatalogueException if the rules draw no inputs of the topic, or too few steps come of
     *     them
     */
    public static Sheet of(String topic, Predicting rules, long seed) {
        Random random = new Random(seed);
        InputTemplate template = InputTemplate.of(place(), rules.inputs());
        Set<String> inputs = new HashSet<>();
        List<Question> questions = new ArrayList<>();
        for (int left = MOST_INPUTS; questions.size() < rules.steps(); left--) {
            if (left == 0)
                throw new CatalogueException(
                        Phrase.of("predict.few", questions.size(), rules.steps(), MOST_INPUTS));
            String input = template.next(random).toString();
            // the same again would be answered already
            if (!inputs.add(input)) continue;
            walk(topic, rules, input).ifPresent(walk -> add(questions, rules, input, walk));
        }
        return new Sheet(seed, questions);
    }

    private static Phrase place() {
        return Phrase.of("field", Phrase.quoted("exercise.json"), "predict");
    }

    /**
     * The walk; empty where the method refuses the input, has too few steps on it, or one that
     * cannot be answered.
     */
    private static Optional<Walk> walk(String topic, Predicting rules, String input) {
        try {
            return Optional.of(Walk.of(topic, rules.method(), input))
                    .filter(walk -> walk.steps().size() - rules.shown() >= rules.least())
                    .filter(
                            walk ->
                                    asked(walk, rules).stream()
                                            .allMatch(step -> isAnswerable(step, rules)));
        } catch (InvalidInput invalid) {
            throw new CatalogueException(
                    Phrase.of(
                            "field.wrong",
                            Phrase.of("field", place(), "given"),
                            Phrase.quoted(invalid.getMessage())),
                    invalid);
        } catch (IllegalArgumentException refused) {
            return Optional.empty();
        }
    }

    private static List<JsonNode> asked(Walk walk, Predicting rules) {
        int end = Math.min(walk.steps().size(), rules.shown() + rules.most());
        return walk.steps().subList(rules.shown(), end);
    }

    /** Whether a step can be asked for: not where a value is none, or a word that is not listed. */
    private static boolean isAnswerable(JsonNode step, Predicting rules) {
        return rules.asked().stream()
                .noneMatch(
                        one ->
                                step.path(one.field()).isNull()
                                        || !one.words().isEmpty()
                                                && !one.words()
                                                        .contains(step.path(one.field()).asText()));
    }

    private static void add(List<Question> questions, Predicting rules, String input, Walk walk) {
        int at = rules.shown();
        for (JsonNode step : asked(walk, rules)) {
            if (questions.size() == rules.steps()) return;
            List<JsonNode> before = walk.steps().subList(0, at++);
            questions.add(new Question(rules, questions.size() + 1, input, before, step));
        }
    }
}
