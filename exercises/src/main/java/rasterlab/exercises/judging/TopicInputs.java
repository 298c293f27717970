package rasterlab.exercises.judging;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.format.Misfit;
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
    private static final int MOST_INPUTS = 1000;

    /** The inputs of a case, and whether it may be refused. */
    record Read<I>(List<I> inputs, boolean mayRefuse) {}

    private final Topic<C, I, ?> topic;
    private final Format<C, I, ?> format;

    TopicInputs(Topic<C, I, ?> topic) {
        this.topic = topic;
        this.format = topic.format();
    }

    /**
     * The inputs of a case.
     *
     * @param seed draws those of a generated case, together with the case's name
     * @throws CatalogueException when a field is missing, unknown, or no input of the topic
     */
    Read<I> of(Case one, long seed) {
        String field = one.generated() ? "generate" : "input";
        Phrase place = Phrase.of("field", Phrase.of("field.case", one.name()), field);
        if (one.generated())
            return new Read<>(
                    drawn(place, one.input(), new Random(31 * seed + one.name().hashCode())),
                    false);
        JsonFields fields = JsonFields.parse(place, one.input(), "given", "hazard", "mayRefuse");
        if (fields.has("given") == fields.has("hazard"))
            throw fields.wrong("", Phrase.of("field.either", "given", "hazard"));
        I input =
                fields.has("hazard")
                        ? hazard(fields)
                        : input(Phrase.of("field", place, "given"), fields.json("given"));
        return new Read<>(List.of(input), fields.flag("mayRefuse", false));
    }

    private I hazard(JsonFields fields) {
        String name = fields.word("hazard", topic.hazards().stream().map(Hazard::name).toList());
        return topic.hazards().stream()
                .filter(hazard -> hazard.name().equals(name))
                .findFirst()
                .orElseThrow()
                .input();
    }

    /**
     * Inputs that are drawn.
     *
     * @param json {@code count}, and {@code given} as a template
     */
    List<I> drawn(Phrase place, String json, Random random) {
        return drawn(place, json, random, MOST_INPUTS);
    }

    /** At most so many of them, which tell whether the others can be drawn. */
    List<I> drawn(Phrase place, String json, Random random, int most) {
        JsonFields fields = JsonFields.parse(place, json, "count", "given");
        Phrase given = Phrase.of("field", place, "given");
        Template template = new Template(given, fields.json("given"));
        int count = Math.min(most, fields.integer("count", 1, MOST_INPUTS));
        List<I> inputs = new ArrayList<>();
        for (int left = count; left > 0; left--) inputs.add(input(given, template.draw(random)));
        return inputs;
    }

    private I input(Phrase place, String json) {
        byte[] text = json.getBytes(StandardCharsets.UTF_8);
        try {
            return format.read(StrictJson.read(text, text.length, format.input(), format.open()));
        } catch (Misfit misfit) {
            throw new CatalogueException(
                    Phrase.of("field.wrong", place, Phrase.quoted(misfit.getMessage())));
        }
    }
}
