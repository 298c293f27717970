package rasterlab.exercises.judging;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.Supplier;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/**
 * Draws the inputs to time a method on, by what the exercise says in {@code timed}: one template,
 * or parts with one each. A part with traits is left out where answers to inputs of just these
 * traits were wrong for a reason that no points were lost for, as long as half of the parts are
 * left.
 */
final class TimedInputs<C, I> implements Supplier<List<TimedInput<I>>> {
    /**
     * The most parts for which all ways to be wrong in some and right in the others can be tried.
     */
    private static final int MOST_PARTS = 10;

    private final TopicInputs<C, I> inputs;
    private final Random random;
    private final int count;
    private final List<Drawing<I>> parts;
    private final List<Integer> left = new ArrayList<>();

    /**
     * @param wrongOn traits of the inputs whose answers were wrong for no known reason
     * @throws CatalogueException if the exercise's data cannot be used
     */
    TimedInputs(
            Topic<C, I, ?> topic,
            Exercise exercise,
            Random random,
            Collection<Set<String>> wrongOn) {
        this.inputs = new TopicInputs<>(topic, false);
        this.random = random;
        Phrase place = Phrase.quoted("timed");
        String data =
                exercise.timed()
                        .orElseThrow(
                                () ->
                                        new CatalogueException(
                                                Phrase.of(
                                                        "field.wrong",
                                                        place,
                                                        Phrase.of("field.missing"))));
        JsonFields fields = JsonFields.parse(place, data, "count", "let", "given", "parts");
        if (fields.has("given") == fields.has("parts"))
            throw fields.wrong("", Phrase.of("field.either", "given", "parts"));
        this.count = fields.integer("count", 1, TopicInputs.MOST_INPUTS);
        NamedNumbers let = inputs.let(place, fields);
        this.parts = new ArrayList<>();
        List<JsonFields> all = fields.objects("parts", "traits", "given");
        if (all.size() > MOST_PARTS)
            throw fields.wrong("parts", Phrase.of("field.parts", MOST_PARTS));
        int wrong = 0;
        for (JsonFields part : all) {
            Set<String> traits = Set.copyOf(part.texts("traits"));
            if (wrongOn.contains(traits)) wrong++;
            else left.add(parts.size());
            parts.add(inputs.drawing(place, part, let));
        }
        if (all.isEmpty()) parts.add(inputs.drawing(place, fields, let));
        if (2 * wrong > parts.size() || all.isEmpty()) {
            left.clear();
            for (int i = 0; i < parts.size(); i++) left.add(i);
        }
        for (Drawing<I> part : parts) part.next(random);
    }

    @Override
    public List<TimedInput<I>> get() {
        List<TimedInput<I>> drawn = new ArrayList<>();
        while (drawn.size() < count) {
            int part = left.get(left.size() == 1 ? 0 : random.nextInt(left.size()));
            for (I input : parts.get(part).next(random)) drawn.add(new TimedInput<>(input, part));
        }
        return drawn;
    }
}
