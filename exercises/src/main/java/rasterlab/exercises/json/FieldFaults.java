package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.IntNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.InvalidInput;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.score.Phrase;

/**
 * Finds all that is wrong within one field of an input. A reader stops at the first fault, so a
 * faulty item of an array is replaced by another one and the field read again.
 */
public final class FieldFaults {
    /** Readings of one field; with more faults the rest are not counted. */
    private static final int MOST = 200;

    private final Phrase place;
    private final Field<?> field;
    private final ObjectNode alone = JsonNodeFactory.instance.objectNode();

    /** How often each place was mended. */
    private final Map<String, Integer> mended = new HashMap<>();

    private FieldFaults(Phrase place, Field<?> field, JsonNode value) {
        this.place = place;
        this.field = field;
        alone.set(field.name(), value.deepCopy());
    }

    /**
     * Keeps what is wrong in a field.
     *
     * @param place what messages call the input
     */
    public static void check(JsonFields fields, Phrase place, Field<?> field, Faults faults) {
        if (!fields.has(field.name())) faults.checked(() -> fields.tree(field.name()));
        else new FieldFaults(place, field, fields.tree(field.name())).keep(faults);
    }

    private void keep(Faults faults) {
        for (int i = 0; i < MOST; i++) {
            Optional<CatalogueException> fault = fault();
            if (fault.isEmpty()) return;
            Optional<InvalidInput> invalid = invalid();
            String at = invalid.map(InvalidInput::place).orElse("");
            if (!mended.containsKey(at)) faults.keep(fault.get());
            if (!mend(at)) return;
        }
    }

    private Optional<CatalogueException> fault() {
        try {
            JsonFields.of(place, alone).get(field);
            return Optional.empty();
        } catch (InvalidInput invalid) {
            String said = invalid().orElse(invalid).getMessage();
            return Optional.of(
                    new CatalogueException(
                            Phrase.of("field.wrong", place, Phrase.ofTheEngine(said)), invalid));
        } catch (CatalogueException placed) {
            return Optional.of(placed);
        }
    }

    /** This fault with its place as a JSON pointer. */
    private Optional<InvalidInput> invalid() {
        byte[] text = alone.toString().getBytes(StandardCharsets.UTF_8);
        try {
            StrictJson.read(text, text.length, List.of(field), false);
            return Optional.empty();
        } catch (InvalidInput invalid) {
            return Optional.of(invalid);
        }
    }

    /** Puts another value at a place in an array; false where there is none to try. */
    private boolean mend(String at) {
        if (!at.startsWith("/")) return false;
        JsonPointer pointer = JsonPointer.compile(at);
        JsonNode around = alone.at(pointer.head());
        int index = pointer.last().getMatchingIndex();
        if (!(around instanceof ArrayNode array) || index < 0 || index >= array.size())
            return false;
        int times = mended.merge(at, 1, Integer::sum) - 1;
        List<JsonNode> values = values(array, pointer.head().toString(), index);
        if (times >= values.size()) return false;
        array.set(index, values.get(times).deepCopy());
        return true;
    }

    /** The values that may be right there: 1, 0, or another item of the array. */
    private List<JsonNode> values(ArrayNode array, String above, int index) {
        List<JsonNode> values = new ArrayList<>();
        for (int i = 0; i < array.size() && values.size() < 3; i++)
            if (i != index && !mended.containsKey(above + "/" + i)) values.add(array.get(i));
        values.add(IntNode.valueOf(1));
        values.add(IntNode.valueOf(0));
        return values;
    }
}
