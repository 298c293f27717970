package rasterlab.exercises.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.study.Format;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.score.Phrase;

/**
 * One JSON object of an exercise's data, read strictly: a missing, unknown or out-of-range field is
 * a {@link CatalogueException} that names the place and what is allowed.
 */
public final class JsonFields {
    private final Value object;

    /** Takes unknown fields, which are passed over then; empty where the first is thrown. */
    private final Optional<Consumer<CatalogueException>> unknown;

    private JsonFields(
            Value object, Optional<Consumer<CatalogueException>> unknown, String... known) {
        object.requireObject(unknown.isPresent() ? new String[0] : known);
        this.unknown = unknown;
        this.object = unknown.isPresent() && known.length > 0 ? object.only(known) : object;
        if (this.object != object)
            for (String name : object.names())
                if (!this.object.has(name)) unknown.get().accept(refusal(name, known));
    }

    private JsonFields(Value object, String... known) {
        this(object, Optional.empty(), known);
    }

    /**
     * These fields, of which each unknown one within an object of theirs is kept instead of thrown,
     * so that reading goes on to what else is wrong there.
     */
    public JsonFields keeping(Consumer<CatalogueException> unknown) {
        return new JsonFields(object, Optional.of(unknown));
    }

    /**
     * Reads an object.
     *
     * @param place what a message calls it, such as "exercise.json"
     * @param known the fields that may occur; none given: any
     */
    public static JsonFields parse(String place, String json, String... known) {
        return parse(Phrase.quoted(place), json, known);
    }

    /** Reads JSON where words of ours say the place. */
    public static JsonFields parse(Phrase place, String json, String... known) {
        return new JsonFields(new Value(place, "", Value.read(place, json)), known);
    }

    /** The fields of an object that is read already. */
    public static JsonFields of(Phrase place, JsonNode object, String... known) {
        return new JsonFields(new Value(place, "", object), known);
    }

    /** Reads an array of objects, each of which may have the known fields; none given: any. */
    public static List<JsonFields> parseArray(String file, String json, String... known) {
        Phrase place = Phrase.quoted(file);
        var objects = new ArrayList<JsonFields>();
        for (Value item : new Value(place, "", Value.read(place, json)).members())
            objects.add(
                    new JsonFields(
                            item.called(Phrase.quoted(file + "[" + objects.size() + "]")), known));
        return objects;
    }

    /** The names of those of its fields that are not among the known ones, in order. */
    public List<String> unknown(String... known) {
        return object.names().stream().filter(one -> !List.of(known).contains(one)).toList();
    }

    /** Refuses a field that is not among the known ones. */
    public CatalogueException refusal(String unknown, String... known) {
        return object.at(unknown).wrong(Phrase.of("field.unknown", object.listed(known)));
    }

    public boolean has(String field) {
        return object.has(field);
    }

    public JsonFields object(String field, String... known) {
        return new JsonFields(required(field), unknown, known);
    }

    /** An array of objects, each of which may have the known fields; none where it is missing. */
    public List<JsonFields> objects(String field, String... known) {
        if (!has(field)) return List.of();
        return object.at(field).members().stream()
                .map(item -> new JsonFields(item, unknown, known))
                .toList();
    }

    /** The object at a place of an array that is long enough. */
    public JsonFields object(String field, int index, String... known) {
        return new JsonFields(required(field).members().get(index), unknown, known);
    }

    public String text(String field) {
        return required(field).text();
    }

    /** A text, which may be blank where whoever asks for it has a refusal of its own. */
    public String anyText(String field) {
        Value value = required(field);
        return value.isText() ? value.node.textValue() : value.text();
    }

    /** One of the allowed words. */
    public String word(String field, List<String> allowed) {
        return required(field).read(in -> in.word(allowed));
    }

    /** One of some words; that one where the field is missing. */
    public String word(String field, List<String> allowed, String otherwise) {
        return has(field) ? word(field, allowed) : otherwise;
    }

    public int integer(String field, int least, int most) {
        return required(field).integer(least, most);
    }

    public int integer(String field, int least, int most, int otherwise) {
        return has(field) ? integer(field, least, most) : otherwise;
    }

    /** A whole number of an array that is long enough. */
    public int member(String field, int index, int least, int most) {
        return required(field).members().get(index).integer(least, most);
    }

    public boolean flag(String field, boolean otherwise) {
        return has(field) ? object.at(field).flag() : otherwise;
    }

    public List<String> texts(String field) {
        return required(field).texts();
    }

    /** A field that must be there, as it stands. */
    public JsonNode tree(String field) {
        return required(field).node;
    }

    /** This object as it stands. */
    public JsonNode tree() {
        return object.node;
    }

    /** The value of a field that must be there, by its shape. */
    public <T> T get(Field<T> field) {
        return given(List.of(field)).get(field);
    }

    /**
     * The input that a topic's format makes of these fields.
     *
     * @throws InvalidInput if it makes none of them
     */
    public <I> I input(Format<?, I, ?> format) {
        return format.read(given(format.input()));
    }

    private Given given(List<Field<?>> fields) {
        return object.read(in -> in.openObject(fields));
    }

    /** An exception that names this place and the field; with no field this place alone. */
    public CatalogueException wrong(String field, Phrase what) {
        return (field.isEmpty() ? object : object.at(field)).wrong(what);
    }

    private Value required(String field) {
        return object.required(field);
    }

    /** A value by the words for the place that it is in, and by its field there. */
    private static final class Value extends JsonPlace<Value> {
        private final Phrase in;

        /** The name of the field, empty for {@link #in} itself. */
        private final String field;

        private final JsonNode node;

        Value(Phrase in, String field, JsonNode node) {
            super(node);
            this.in = in;
            this.field = field;
            this.node = node;
        }

        static JsonNode read(Phrase place, String json) {
            try {
                return JsonText.tree(json);
            } catch (NotJson e) {
                throw wrong(place, Phrase.of("json.not", e.phrase()), e);
            }
        }

        /** This object without other fields; itself where it has none. */
        Value only(String... known) {
            ObjectNode left = node.deepCopy();
            left.retain(known);
            return left.size() == node.size() ? this : new Value(in, field, left);
        }

        Value called(Phrase name) {
            return new Value(name, "", node);
        }

        private Phrase place() {
            return field.isEmpty() ? in : Phrase.of("field", in, field);
        }

        @Override
        protected Value field(String name, JsonNode value) {
            return new Value(place(), name, value);
        }

        @Override
        protected Value member(int index, JsonNode value) {
            return new Value(in, field + "[" + index + "]", value);
        }

        /** {@inheritDoc} A point is told as a whole. */
        @Override
        protected Value number(int index, JsonNode value) {
            return new Value(in, field, value);
        }

        @Override
        protected String listed(String... known) {
            return Arrays.toString(known);
        }

        List<String> texts() {
            var texts = new ArrayList<String>();
            for (JsonNode item : node) if (item.isTextual()) texts.add(item.textValue());
            if (!isArray() || texts.isEmpty() || texts.size() != node.size())
                throw wrong(Phrase.of("field.texts", shown()));
            return texts;
        }

        @Override
        protected CatalogueException wrong(Phrase what) {
            return wrong(place(), what, null);
        }

        private static CatalogueException wrong(Phrase place, Phrase what, Throwable cause) {
            return new CatalogueException(Phrase.of("field.wrong", place, what), cause);
        }
    }
}
