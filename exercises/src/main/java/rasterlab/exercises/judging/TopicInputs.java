package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.json.StrictJson;
import rasterlab.exercises.score.Phrase;

/**
 * Reads a topic's inputs from the data of an exercise: as {@code ./lab run} takes them, by the name
 * of a hazard, or drawn by a {@link Template}.
 */
final class TopicInputs<C, I> {
    static final int MOST_INPUTS = 1000;

    /**
     * The inputs of a case, and what it asks for.
     *
     * @param mayRefuse whether a refusal is as good as the answer
     * @param strict whether the tolerance of the exercise does not hold
     * @param first the most items of an answer that are looked at, where that is said
     */
    record Read<I>(List<I> inputs, boolean mayRefuse, boolean strict, OptionalInt first) {}

    private final Topic<C, I, ?> topic;
    private final Format<C, I, ?> format;
    private final boolean inOrder;

    /** The names of an input's fields. */
    private final String[] names;

    /**
     * @param inOrder whether all right answers have their items in one order, so that a case may
     *     ask for the first ones
     */
    TopicInputs(Topic<C, I, ?> topic, boolean inOrder) {
        this.topic = topic;
        this.format = topic.format();
        this.inOrder = inOrder;
        this.names = format.input().stream().map(Field::name).toArray(String[]::new);
    }

    /**
     * The inputs of a case.
     *
     * @param seed draws those of a generated case, together with the case's name
     * @throws CatalogueException when a field is missing, unknown, or no input of the topic
     */
    Read<I> of(Case one, long seed) {
        Phrase place = place(one);
        if (one.property().isPresent()) return ofProperty(one, place, seed);
        if (one.generated()) {
            JsonFields fields =
                    JsonFields.parse(place, one.input(), "count", "let", "given", "strict");
            return new Read<>(
                    drawn(place, fields, random(one, seed)),
                    false,
                    fields.flag("strict", false),
                    OptionalInt.empty());
        }
        JsonFields fields = fields(place, one);
        if (fields.has("given") == fields.has("hazard"))
            throw fields.wrong("", Phrase.of("field.either", "given", "hazard"));
        return new Read<>(
                fields.has("hazard")
                        ? hazard(fields)
                        : given(Phrase.of("field", place, "given"), fields),
                fields.flag("mayRefuse", false),
                fields.flag("strict", false),
                fields.has("first")
                        ? OptionalInt.of(fields.integer("first", 1, topic.mostItems()))
                        : OptionalInt.empty());
    }

    /** One that is open has a seed of its own, the same for everybody. */
    private Read<I> ofProperty(Case one, Phrase place, long seed) {
        JsonFields fields = JsonFields.parse(place, one.input(), "count", "let", "given", "seed");
        long own = fields.has("seed") ? fields.integer("seed", 0, Integer.MAX_VALUE) : seed;
        List<I> inputs = drawn(place, fields, random(one, own));
        return new Read<>(inputs, false, false, OptionalInt.empty());
    }

    private static Random random(Case one, long seed) {
        return new Random(31 * seed + one.name().hashCode());
    }

    private JsonFields fields(Phrase place, Case one) {
        return inOrder
                ? JsonFields.parse(
                        place, one.input(), "given", "hazard", "mayRefuse", "strict", "first")
                : JsonFields.parse(place, one.input(), "given", "hazard", "mayRefuse", "strict");
    }

    /** The place of a case's input, for people. */
    static Phrase place(Case one) {
        return Phrase.of(
                "field",
                Phrase.of("field.case", one.name()),
                one.property().isPresent() ? "property" : one.generated() ? "generate" : "input");
    }

    /** The input of a hazard; where it is several as they are told outside, those. */
    private List<I> hazard(JsonFields fields) {
        String name = fields.word("hazard", topic.hazards().stream().map(Hazard::name).toList());
        I input =
                topic.hazards().stream()
                        .filter(hazard -> hazard.name().equals(name))
                        .findFirst()
                        .orElseThrow()
                        .input();
        if (untold(input).isEmpty()) return List.of(input);
        List<I> singles = format.singles(input);
        for (I one : singles)
            untold(one)
                    .ifPresent(
                            why -> {
                                throw fields.wrong("hazard", Phrase.of("field.untold", name, why));
                            });
        return singles;
    }

    /** Why no report could show an input; empty where it can. */
    private Optional<Phrase> untold(I input) {
        try {
            Leaves.tree(format, input);
            return Optional.empty();
        } catch (IllegalArgumentException untold) {
            return Optional.of(Phrase.ofTheEngine(untold.getMessage()));
        }
    }

    /** One input, or several that are tried one after the other. */
    private List<I> given(Phrase place, JsonFields fields) {
        JsonNode given = fields.tree("given");
        if (!given.isArray()) return List.of(input(place, given));
        if (given.isEmpty()) throw fields.wrong("given", Phrase.of("template.turns", "[]"));
        List<I> inputs = new ArrayList<>();
        for (JsonNode one : given) inputs.add(input(place, one));
        return inputs;
    }

    private List<I> drawn(Phrase place, JsonFields fields, Random random) {
        Drawing<I> drawing = drawing(place, fields, let(place, fields));
        List<I> inputs = new ArrayList<>();
        for (int left = fields.integer("count", 1, MOST_INPUTS); left > 0; left--)
            inputs.addAll(drawing.next(random));
        return inputs;
    }

    /** The numbers of the field {@code let}, if it is there. */
    NamedNumbers let(Phrase place, JsonFields fields) {
        return new NamedNumbers(
                Phrase.of("field", place, "let"),
                fields.has("let")
                        ? fields.object("let").tree()
                        : JsonNodeFactory.instance.objectNode());
    }

    /**
     * The template that draws inputs by the field {@code given}: a template, or an array of turns,
     * each a template or an array of such that share the drawn numbers.
     */
    Drawing<I> drawing(Phrase place, JsonFields fields, NamedNumbers let) {
        Phrase given = Phrase.of("field", place, "given");
        JsonNode tree = fields.tree("given");
        List<List<Template>> turns = new ArrayList<>();
        if (tree.isArray()) {
            for (JsonNode turn : tree) turns.add(templates(given, turn, let));
        } else turns.add(templates(given, tree, let));
        if (turns.isEmpty() || turns.stream().anyMatch(List::isEmpty))
            throw fields.wrong("given", Phrase.of("template.turns", tree.toString()));
        return new Drawing<>(let, turns, json -> input(given, json));
    }

    private static List<Template> templates(Phrase place, JsonNode turn, NamedNumbers let) {
        if (!turn.isArray()) return List.of(new Template(place, turn, let));
        List<Template> together = new ArrayList<>();
        for (JsonNode one : turn) together.add(new Template(place, one, let));
        return together;
    }

    private I input(Phrase place, JsonNode json) {
        try {
            return format.open()
                    ? openInput(json.toString())
                    : JsonFields.of(place, json, names).input(format);
        } catch (InvalidInput invalid) {
            throw new CatalogueException(
                    Phrase.of("field.wrong", place, Phrase.ofTheEngine(invalid.getMessage())));
        }
    }

    /** The format itself looks at fields by names that are known nowhere else. */
    private I openInput(String json) {
        return read(format, json);
    }

    private static <I> I read(Format<?, I, ?> format, String json) {
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        return format.read(StrictJson.read(text, text.length, format.input(), format.open()));
    }

    /** An input of a format; empty where that JSON is none. */
    static <I> Optional<I> read(Format<?, I, ?> format, JsonNode json) {
        try {
            return Optional.of(read(format, json.toString()));
        } catch (InvalidInput | IllegalArgumentException none) {
            return Optional.empty();
        }
    }
}
