package rasterlab.engine.format;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The values of the fields that one object has. */
public final class Given {
    private final String place;
    private final Map<String, Object> values = new HashMap<>();
    private final List<String> unknown = new ArrayList<>();

    /**
     * @param place the object's JSON pointer (RFC 6901); empty for the whole input
     */
    public Given(String place) {
        this.place = place;
    }

    /** Fields to be written. */
    public Given() {
        this("");
    }

    /** The value of a required field. */
    @SuppressWarnings("unchecked") // the field's own shape made the value
    public <T> T get(Field<T> field) {
        if (!has(field.name())) throw new AssertionError(field.name() + " was let through");
        return (T) values.get(field.name());
    }

    /** The value of a field; {@code otherwise} where it was not given. */
    @SuppressWarnings("unchecked") // the field's own shape made the value
    public <T> T get(Field<T> field, T otherwise) {
        return has(field.name()) ? (T) values.get(field.name()) : otherwise;
    }

    /** The value of an optional field, if it was given. */
    public <T> Optional<T> find(Field<T> field) {
        return Optional.ofNullable(get(field, null));
    }

    /** The names of the fields that were given. */
    public Set<String> names() {
        return Set.copyOf(values.keySet());
    }

    public boolean has(String name) {
        return values.containsKey(name);
    }

    public boolean has(Field<?> field) {
        return has(field.name());
    }

    /** The names of the fields that were passed over, in their order. */
    public List<String> unknown() {
        return List.copyOf(unknown);
    }

    /** Adds the name of a field that was passed over. */
    public void putUnknown(String name) {
        unknown.add(name);
    }

    /** Adds a value that the field's shape has read. */
    public void put(Field<?> field, Object value) {
        values.put(field.name(), value);
    }

    /** These values with one value more. */
    public <T> Given with(Field<T> field, T value) {
        put(field, value);
        return this;
    }

    /** Writes those of the fields that were given. */
    public void write(List<Field<?>> fields, ValueSink out) throws IOException {
        for (Field<?> field : fields) if (has(field)) write(field, out);
    }

    private <T> void write(Field<T> field, ValueSink out) throws IOException {
        out.name(field.name());
        field.shape().write(get(field), out);
    }

    /** A complaint about the value of a field, with its place. */
    public InvalidInput invalid(String field, String reason) {
        return new InvalidInput(place + "/" + field, reason);
    }

    /**
     * A complaint about the fields where something made of them refuses them: about the one whose
     * name, with the numbers of places in its value, stands before "must" in the refusal.
     */
    public InvalidInput invalid(IllegalArgumentException refusal) {
        Matcher named = Refusal.NAMED.matcher(refusal.getMessage());
        if (!named.matches() || !has(named.group(1)))
            return new InvalidInput(place.isEmpty() ? "/" : place, refusal.getMessage());
        String numbers = named.group(2).replace("]", "").replace('[', '/');
        String axis = named.group(3) == null ? "" : "/" + "xyz".indexOf(named.group(3));
        return invalid(named.group(1) + numbers + axis, named.group(4));
    }

    /** A refusal, which is made only where something is refused. */
    private static final class Refusal {
        /** Matches a place and what is wrong there, such as "vertices[3].x must be from …". */
        static final Pattern NAMED =
                Pattern.compile(
                        "([\\w-]+)((?:\\[\\d+])*)(?:\\.([xyz]))? (must .*)", Pattern.DOTALL);
    }
}
