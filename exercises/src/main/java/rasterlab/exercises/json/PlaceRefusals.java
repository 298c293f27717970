package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonStreamContext;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.exercises.score.Phrase;

/** Refuses values of a file of people, in words of its own places. */
final class PlaceRefusals implements Refusals {
    private final JsonPlace<?> root;
    private final JsonParser parser;

    /**
     * @param root the place of the value that {@code parser} reads
     */
    PlaceRefusals(JsonPlace<?> root, JsonParser parser) {
        this.parser = parser;
        this.root = root;
    }

    @Override
    public RuntimeException other(Expected allowed) {
        return allowed.refused(place(parser.getParsingContext(), allowed.inOneThing()));
    }

    @Override
    public InvalidInput invalid(String reason) {
        return new InvalidInput(reason);
    }

    @Override
    public InvalidInput invalidArray(String reason) {
        return invalid(reason);
    }

    @Override
    public RuntimeException unknown(List<Field<?>> fields) {
        return root.unknown(
                parser.getParsingContext().getCurrentName(),
                fields.stream().map(Field::name).toArray(String[]::new));
    }

    @Override
    public RuntimeException missing(Given object, Field<?> field) {
        return root.at(field.name()).wrong(Phrase.of("field.missing"));
    }

    @Override
    public String pointer() {
        return "";
    }

    @Override
    public int length() {
        return place().node().size();
    }

    @Override
    public boolean strict() {
        return true;
    }

    /**
     * {@inheritDoc} Of several mistakes in it the first in the order of the format is told, but for
     * a field that is unknown.
     */
    @Override
    public StrictJson object(StrictJson reader, List<Field<?>> fields) throws IOException {
        JsonPlace<?> object = place();
        parser.skipChildren();
        return StrictJson.at(object, inOrder(object.node(), fields));
    }

    /**
     * The object with its unknown fields first, and behind them the others, up to the first one
     * that is missing.
     */
    private static JsonNode inOrder(JsonNode object, List<Field<?>> fields) {
        ObjectNode unknown = JsonNodeFactory.instance.objectNode();
        unknown.setAll((ObjectNode) object);
        var known = new LinkedHashMap<String, JsonNode>();
        boolean complete = true;
        for (Field<?> field : fields) {
            JsonNode value = unknown.remove(field.name());
            complete &= value != null || !field.required();
            if (complete && value != null) known.put(field.name(), value);
        }
        return unknown.setAll(known);
    }

    private JsonPlace<?> place() {
        return place(parser.getParsingContext(), false);
    }

    private JsonPlace<?> place(JsonStreamContext at, boolean inOneThing) {
        if (at.inRoot()) return root;
        if (!at.hasPathSegment()) return place(at.getParent(), inOneThing);
        JsonPlace<?> outer = place(at.getParent(), false);
        if (at.inObject()) return outer.at(at.getCurrentName());
        return inOneThing ? outer.number(at.getCurrentIndex()) : outer.member(at.getCurrentIndex());
    }
}
