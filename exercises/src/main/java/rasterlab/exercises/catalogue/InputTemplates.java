package rasterlab.exercises.catalogue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/**
 * Templates of inputs that {@code exercise.json} names, so that several cases can use one: a
 * template, or an array of turns, in which the name of another shape stands for its template.
 */
final class InputTemplates {
    /** A shape may be made of others, and these of simple ones. */
    private static final int DEEPEST = 3;

    private final JsonFields exercise;
    private final JsonNode shapes;

    private InputTemplates(JsonFields exercise, JsonNode shapes) {
        this.exercise = exercise;
        this.shapes = shapes;
    }

    static InputTemplates read(JsonFields exercise) {
        JsonNode shapes =
                exercise.has("shapes")
                        ? exercise.object("shapes").tree()
                        : JsonNodeFactory.instance.objectNode();
        InputTemplates read = new InputTemplates(exercise, shapes);
        read.names().forEach(read::named);
        return read;
    }

    private List<String> names() {
        return shapes.properties().stream().map(each -> each.getKey()).toList();
    }

    private JsonNode named(String name) {
        return filled(shapes.get(name), 0);
    }

    private JsonNode filled(JsonNode node, int depth) {
        if (node.isTextual() && shapes.has(node.textValue()) && depth < DEEPEST)
            return filled(shapes.get(node.textValue()), depth + 1);
        if (node.isObject()) return node;
        if (!node.isArray())
            throw exercise.wrong("shapes", Phrase.of("field.shape", node.toString()));
        ArrayNode turns = JsonNodeFactory.instance.arrayNode();
        for (JsonNode one : node) turns.add(filled(one, depth + 1));
        return turns;
    }

    /**
     * The rule by which a case draws its inputs, with the template in place of its name.
     *
     * @param left names of fields that say something else and are left out
     */
    String given(JsonFields generate, String... left) {
        ObjectNode all = generate.tree().deepCopy();
        all.remove(List.of(left));
        if (!all.has("shape")) return all.toString();
        if (all.has("given")) throw generate.wrong("given", Phrase.of("field.beside", "shape"));
        String name = generate.word("shape", names());
        ObjectNode given = JsonNodeFactory.instance.objectNode();
        all.properties().stream()
                .filter(each -> !each.getKey().equals("shape"))
                .forEach(each -> given.set(each.getKey(), each.getValue()));
        given.set("given", named(name));
        return given.toString();
    }
}
