package rasterlab.app.cli.run.json;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.app.outcome.Complaint;

/** The fields that one JSON object has. */
public final class Given {
    private final String place;
    private final List<JsonField<?>> allowed;
    private final Map<String, Object> values = new HashMap<>();
    private final List<String> unknown = new ArrayList<>();

    /**
     * @param place the object's JSON pointer; empty for the whole input
     */
    Given(String place, List<JsonField<?>> allowed) {
        this.place = place;
        this.allowed = allowed;
    }

    /** The value of a required field. */
    public <T> T get(JsonField<T> field) {
        return find(field).orElseThrow(() -> new AssertionError(field.name() + " was let through"));
    }

    /** The value of an optional field, if it was given. */
    @SuppressWarnings("unchecked") // the field's own reader made the value
    public <T> Optional<T> find(JsonField<T> field) {
        return Optional.ofNullable((T) values.get(field.name()));
    }

    /** The names of the fields that were given. */
    public Set<String> names() {
        return Set.copyOf(values.keySet());
    }

    public boolean has(String name) {
        return values.containsKey(name);
    }

    /** The names of the fields that were passed over, in their order. */
    public List<String> unknown() {
        return List.copyOf(unknown);
    }

    void putUnknown(String name) {
        unknown.add(name);
    }

    Optional<JsonField<?>> allowed(String name) {
        return allowed.stream().filter(field -> field.name().equals(name)).findFirst();
    }

    void put(JsonField<?> field, Object value) {
        values.put(field.name(), value);
    }

    /** A complaint about the value of a field, with its place. */
    public Complaint complaint(String field, String message) {
        return Complaint.badInput(place + "/" + field + ": " + message);
    }

    void requireAll() {
        for (JsonField<?> field : allowed)
            if (field.required() && !has(field.name()))
                throw Complaint.badInput(place + "/" + field.name() + ": missing");
    }
}
