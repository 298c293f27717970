package rasterlab.exercises.judging;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import rasterlab.engine.Topics;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.InputChanged;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.SharedAnswer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.FieldFaults;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.json.StrictJson;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Phrase;

/**
 * Runs a topic's right and faulty methods and its mutants on an input that somebody chose. A faulty
 * one may go on without end or take all memory, so the process that asks must be one that may be
 * killed.
 */
public final class MethodsOnInput<C, I, O> {
    /** The wall time of one method: much more than any needs for a small input. */
    private static final Duration LIMIT = Duration.ofSeconds(2);

    private final Topic<C, I, O> topic;
    private final I input;

    /** The trial, made when the first method is tried: the exact answer may take long. */
    private Function<Method<C>, HazardTrial.MethodAnswer<O>> trial;

    private MethodsOnInput(Topic<C, I, O> topic, I input) {
        this.topic = topic;
        this.input = input;
    }

    /**
     * An input as {@code ./lab run} takes it.
     *
     * @param place what messages call it
     * @param json an object
     * @throws CatalogueException if it is no input of the topic; says of each field that is wrong
     *     the place, the value and what is allowed
     */
    public static MethodsOnInput<?, ?, ?> of(String topic, Phrase place, String json) {
        return read(Topics.named(topic), place, json);
    }

    private static <C, I, O> MethodsOnInput<C, I, O> read(
            Topic<C, I, O> topic, Phrase place, String json) {
        Format<C, I, O> format = topic.format();
        checkFields(format, place, json);
        try {
            return new MethodsOnInput<>(topic, JsonFields.parse(place, json).input(format));
        } catch (InvalidInput invalid) {
            throw new CatalogueException(
                    Phrase.of(
                            "field.wrong",
                            place,
                            Phrase.ofTheEngine(
                                    placed(invalid, format.input(), format.open(), json))),
                    invalid);
        } catch (CatalogueException placed) {
            throw placed;
        } catch (IllegalArgumentException refused) {
            throw new CatalogueException(
                    Phrase.of("field.wrong", place, Phrase.ofTheEngine(refused.getMessage())),
                    refused);
        }
    }

    /** Reads each field alone, so that all that is wrong is told. */
    private static void checkFields(Format<?, ?, ?> format, Phrase place, String json) {
        JsonFields fields = JsonFields.parse(place, json);
        var faults = new Faults();
        faults.checkKnown(fields, format.input().stream().map(Field::name).toArray(String[]::new));
        for (Field<?> one : format.input())
            if (one.required() || fields.has(one.name()))
                FieldFaults.check(fields, place, one, faults);
        faults.requireNoneOfAll();
    }

    /** The message of an invalid input with its place in the JSON. */
    private static String placed(
            InvalidInput invalid, List<Field<?>> fields, boolean open, String json) {
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        try {
            StrictJson.read(text, text.length, fields, open);
            return invalid.getMessage();
        } catch (InvalidInput same) {
            return same.getMessage();
        }
    }

    /**
     * The outcome of one method.
     *
     * @param message what is wrong with its answer, or why there is none; nothing where it is exact
     */
    public record MethodResult(String method, Verdict.Kind kind, Message message) {
        /** Whether it gave an answer that is not exact, or none without saying why. */
        public boolean failed() {
            return kind != Verdict.Kind.EXACT && kind != Verdict.Kind.REFUSED;
        }
    }

    /** Names of the methods of a topic that an exercise may ask to break. */
    public static List<String> breakable(String topic) {
        return List.copyOf(faulty(Topics.named(topic)).keySet());
    }

    private static <C> Map<String, C> faulty(Topic<C, ?, ?> topic) {
        Map<String, C> faulty = new LinkedHashMap<>();
        for (Method<C> one : topic.methods())
            if (one.faulty()) faulty.put(one.name(), one.implementation());
        for (Mutant<C> one : topic.mutants()) faulty.put(one.name(), one.implementation());
        return faulty;
    }

    /** The methods that promise to be right. */
    public List<MethodResult> right() {
        return topic.methods().stream()
                .filter(Method::promisesToBeRight)
                .map(one -> tried(one.name(), one.implementation()))
                .toList();
    }

    /**
     * The faulty methods and mutants of these names, in the topic's order.
     *
     * @param names of {@link #breakable}
     */
    public List<MethodResult> faulty(Set<String> names) {
        List<MethodResult> tried = new ArrayList<>();
        faulty(topic)
                .forEach(
                        (name, method) -> {
                            if (names.contains(name)) tried.add(tried(name, method));
                        });
        return tried;
    }

    private MethodResult tried(String name, C implementation) {
        if (trial == null) trial = HazardTrial.trying(topic, input, LIMIT);
        HazardTrial.MethodAnswer<O> tried = trial.apply(Method.failing(name, implementation));
        Verdict verdict = tried.verdict();
        Message said =
                switch (verdict.kind()) {
                    case EXACT -> Message.NONE;
                    case REFUSED -> Message.of("break.refuses", verdict.detail());
                    case ENDLESS -> Message.of("break.endless");
                    case CRASHED -> Message.of("break.crashes", verdict.detail());
                    case DEGRADED, WRONG ->
                            tried.made()
                                    .map(
                                            made ->
                                                    AnswerDifference.of(
                                                            topic, input, tried.exact(), made))
                                    .orElseGet(() -> withoutAnswer(tried));
                };
        return new MethodResult(name, verdict.kind(), said);
    }

    /** Says why there is no answer to compare, in words that are known in every language. */
    private static Message withoutAnswer(HazardTrial.MethodAnswer<?> tried) {
        Throwable thrown = tried.thrown().orElse(null);
        if (thrown instanceof InputChanged) return Message.of("answer.overwrites");
        if (thrown instanceof SharedAnswer shared)
            return Message.of(shared.given() ? "answer.shared-given" : "answer.shared-before");
        return Message.of("break.crashes", tried.verdict().detail());
    }
}
