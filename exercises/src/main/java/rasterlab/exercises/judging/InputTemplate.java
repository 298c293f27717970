package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.Random;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/** Draws inputs of a topic as JSON by one template, with the numbers that {@code let} names. */
public final class InputTemplate {
    private final NamedNumbers let;
    private final Template template;

    private InputTemplate(NamedNumbers let, Template template) {
        this.let = let;
        this.template = template;
    }

    /**
     * A template of data.
     *
     * @param place what messages call it
     * @param json an object with {@code given}, and {@code let} where numbers have names
     * @throws CatalogueException if it has something else, or none
     */
    public static InputTemplate of(Phrase place, String json) {
        JsonFields fields = JsonFields.parse(place, json, "let", "given");
        JsonNode named =
                fields.has("let")
                        ? fields.object("let").tree()
                        : JsonNodeFactory.instance.objectNode();
        var let = new NamedNumbers(Phrase.of("field", place, "let"), named);
        Phrase given = Phrase.of("field", place, "given");
        return new InputTemplate(let, new Template(given, fields.tree("given"), let));
    }

    /**
     * The next input.
     *
     * @throws CatalogueException if a range, a sum or a number of times cannot be
     */
    public JsonNode next(Random random) {
        return template.draw(random, let.draw(random));
    }
}
