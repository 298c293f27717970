package rasterlab.exercises.topic;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.drawing.NumberText;
import rasterlab.exercises.score.Message;

/**
 * Tells how an exercise's cases compare an answer with the right one, and which rule makes that the
 * right one: the tolerance is the exercise's or the topic's own, the rule stands in the topic's
 * words.
 */
public final class CaseRules {
    private CaseRules() {}

    /**
     * Which answers to a case are right.
     *
     * @param tolerance how exactly an answer is compared
     * @param rule on ties, borders or the order of what is answered; nothing where there is none
     */
    public record CaseRule(Message tolerance, Message rule) {}

    /** The rule of the case of that name; empty for a line of a report that is no case. */
    public static Optional<CaseRule> of(Exercise exercise, String name) {
        return exercise.cases().stream()
                .filter(one -> one.name().equals(name))
                .findFirst()
                .map(one -> of(exercise, one));
    }

    private static CaseRule of(Exercise exercise, Case one) {
        if (exercise.predicting().isPresent())
            return new CaseRule(predicted(exercise.predicting().get()), Message.NONE);
        boolean strict = exercise.form() == TaskKind.BREAK || OwnBound.isAskedFor(one);
        var held = strict ? exercise.tolerance().strict() : exercise.tolerance();
        Message tolerance = tolerance(exercise, held.worst());
        return new CaseRule(
                held.truth()
                        .map(method -> tolerance.and(Message.of("compared.truth", method)))
                        .orElse(tolerance),
                first(
                        exercise,
                        "rule",
                        held.eitherPixelOnTies() ? Optional.of("either") : exercise.contract()));
    }

    private static Message predicted(Predicting rules) {
        if (rules.tolerance() == 0) return Message.of("compared.exactly");
        String number = NumberText.of(rules.tolerance());
        return rules.unit().isEmpty()
                ? Message.of("compared.steps", number)
                : Message.of(
                        "compared.steps.unit",
                        number,
                        rules.unit().get("en"),
                        rules.unit().get("ru"));
    }

    private static Message tolerance(Exercise exercise, OptionalDouble stated) {
        Topic<?, ?, ?> topic = Topics.named(exercise.topic());
        Message own = first(exercise, "bound", exercise.contract());
        if (stated.isEmpty() && !own.isEmpty()) return own;
        OptionalDouble bound = stated.isPresent() ? stated : OwnBound.of(topic);
        return bound.isPresent()
                ? Message.of(
                        "compared.within",
                        NumberText.of(bound.getAsDouble()),
                        "bound." + topic.name() + ".unit")
                : Message.of("compared.exactly");
    }

    /** The topic's words of that kind, those for the name before its own; nothing without any. */
    private static Message first(Exercise exercise, String kind, Optional<String> name) {
        return Stream.concat(name.stream(), Stream.of("own"))
                .map(one -> kind + "." + exercise.topic() + "." + one)
                .filter(Message::isKnown)
                .findFirst()
                .map(Message::of)
                .orElse(Message.NONE);
    }
}
