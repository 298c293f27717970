package rasterlab.exercises.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.format.ValueSource;
import rasterlab.exercises.score.Phrase;

/**
 * A value of a JSON text that knows its place; whatever is wrong there is refused with it.
 *
 * <p>Who reads a kind of text says how its places are named and what a refusal is.
 *
 * @param <P> a place of that kind of text
 */
public abstract class JsonPlace<P extends JsonPlace<P>> {
    private static final int SHOWN = 60;

    private final JsonNode node;

    protected JsonPlace(JsonNode node) {
        this.node = node;
    }

    /** The place of a field, which need not be there. */
    protected abstract P field(String name, JsonNode value);

    /** The place of a member of this array. */
    protected abstract P member(int index, JsonNode value);

    /** The place of a number of this array, where it stands for one thing such as a point. */
    protected P number(int index, JsonNode value) {
        return member(index, value);
    }

    /** A refusal of this value. */
    protected abstract IllegalArgumentException wrong(Phrase what);

    /** The names of all fields that are known, for a refusal. */
    protected abstract String listed(String... known);

    /** The place that is named where a field is not known. */
    protected P unknown(String name) {
        return at(name);
    }

    /** How an infinite number, or none, is shown. */
    protected String endless() {
        return node.toString();
    }

    /** Passes if this is an object in which only the known fields occur; none given: any. */
    protected final void requireObject(String... known) {
        if (!node.isObject()) throw Expected.AnObject.noObject(this);
        for (Iterator<String> names = node.fieldNames(); names.hasNext(); ) {
            String name = names.next();
            if (known.length > 0 && !List.of(known).contains(name)) throw unknown(name, known);
        }
    }

    final RuntimeException unknown(String name, String... known) {
        return unknown(name).wrong(Phrase.of("field.unknown", listed(known)));
    }

    final JsonNode node() {
        return node;
    }

    public final boolean has(String field) {
        return node.has(field);
    }

    /** The names of the fields of this object; none where it is something else. */
    public final List<String> names() {
        var names = new ArrayList<String>();
        node.fieldNames().forEachRemaining(names::add);
        return names;
    }

    /** A field that must be there: whoever reads it where it is not is refused. */
    public final P at(String field) {
        return field(field, node.path(field));
    }

    /** A field that is there. */
    protected final P required(String field) {
        if (!has(field)) throw at(field).wrong(Phrase.of("field.missing"));
        return at(field);
    }

    public final Optional<P> optional(String field) {
        return has(field) ? Optional.of(at(field)) : Optional.empty();
    }

    public final boolean isObject() {
        return node.isObject();
    }

    public final boolean isArray() {
        return node.isArray();
    }

    public final boolean isText() {
        return node.isTextual();
    }

    /** Whether this is NaN or infinite, for which JSON has no number. */
    public final boolean isEndless() {
        return node.isFloatingPointNumber() && !Double.isFinite(node.doubleValue());
    }

    /** The members of this array. */
    public final List<P> members() {
        if (!node.isArray()) throw Expected.Items.noArray(this);
        List<P> members = new ArrayList<>();
        for (int i = 0; i < node.size(); i++) members.add(member(i));
        return members;
    }

    final P member(int index) {
        return member(index, node.get(index));
    }

    final P number(int index) {
        return number(index, node.get(index));
    }

    /** Whether this is a text with more than blanks. */
    final boolean saysSomething() {
        return node.isTextual() && !node.textValue().isBlank();
    }

    public final String text() {
        return read(in -> in.text("a text", 0, Integer.MAX_VALUE));
    }

    public final boolean flag() {
        return read(ValueSource::flag);
    }

    public final int integer(int least, int most) {
        return read(in -> in.whole(least, most));
    }

    public final double number(double least, double most) {
        return read(in -> in.numberFrom(least, most));
    }

    /** Returns what is read of this value. */
    protected final <T> T read(ValueReader<T> reading) {
        try {
            return reading.of(StrictJson.at(this));
        } catch (IOException e) {
            throw new AssertionError("reading from memory failed", e);
        }
    }

    /** Reads a value by its shape. */
    protected interface ValueReader<T> {
        T of(ValueSource in) throws IOException;
    }

    /**
     * A number that no double holds, as it stands in the text.
     *
     * @param path such as {@code $.camera.rho}
     */
    protected static String endlessNumber(String path, String json) {
        return EndlessNumber.at(path, json);
    }

    /** The value as JSON text. */
    protected final String asJson() {
        return node.toString();
    }

    /** The value for a refusal. */
    protected final Object shown() {
        if (node.isMissingNode()) return Phrase.of("field.nothing");
        return cut(isEndless() ? endless() : node.toString());
    }

    protected static String cut(String text) {
        return text.length() <= SHOWN ? text : text.substring(0, SHOWN) + "…";
    }
}
