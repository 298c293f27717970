package rasterlab.exercises.scene;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The settings of a scene file for how its scene is drawn; the rest is left to whoever draws it.
 */
public final class Settings {
    /** Nothing is said. */
    public static final Settings NONE = new Settings(Map.of());

    private static final String LOOK = "look";

    private final Map<SceneSetting<?>, Object> values;

    private Settings(Map<SceneSetting<?>, Object> values) {
        this.values = Map.copyOf(values);
    }

    @SuppressWarnings("unchecked") // with and read put nothing but a setting's own values in
    public <T> Optional<T> get(SceneSetting<T> setting) {
        return Optional.ofNullable((T) values.get(setting));
    }

    /**
     * These settings with one thing more, or another value of it.
     *
     * @throws IllegalArgumentException for a value that no file may have
     */
    public <T> Settings with(SceneSetting<T> setting, T value) {
        String json =
                JsonNodeFactory.instance
                        .objectNode()
                        .set(setting.field(), setting.written(value))
                        .toString();
        return put(setting, setting.read(SceneJsonPlace.root(json).at(setting.field())));
    }

    /** These settings with a value of one thing, if there is a value. */
    public <T> Settings with(SceneSetting<T> setting, Optional<T> value) {
        return value.map(given -> with(setting, given)).orElse(this);
    }

    private Settings put(SceneSetting<?> setting, Object value) {
        var next = new HashMap<>(values);
        next.put(setting, value);
        return new Settings(next);
    }

    /** The fields of a file that may hold settings. */
    static String[] fields(String... others) {
        return Stream.of(Arrays.stream(others), names(SceneSetting.OF_VIEW), Stream.of(LOOK))
                .flatMap(names -> names)
                .toArray(String[]::new);
    }

    private static Stream<String> names(List<SceneSetting<?>> settings) {
        return settings.stream().map(SceneSetting::field);
    }

    static Settings read(SceneJsonPlace file) {
        Settings read = NONE.reading(file, SceneSetting.OF_VIEW);
        Optional<SceneJsonPlace> look = file.optional(LOOK);
        if (look.isPresent())
            read =
                    read.reading(
                            look.get().object(names(SceneSetting.OF_LOOK).toArray(String[]::new)),
                            SceneSetting.OF_LOOK);
        Optional<Double> near = read.get(SceneSetting.NEAR);
        Optional<Double> far = read.get(SceneSetting.FAR);
        if (near.isPresent() && far.isPresent() && !(near.get() < far.get()))
            throw file.at(SceneSetting.FAR.field())
                    .wrong("must be above near, %s, got %s".formatted(near.get(), far.get()));
        return read;
    }

    private Settings reading(SceneJsonPlace from, List<SceneSetting<?>> settings) {
        Settings read = this;
        for (SceneSetting<?> setting : settings) {
            Optional<SceneJsonPlace> place = from.optional(setting.field());
            if (place.isPresent()) read = read.put(setting, setting.read(place.get()));
        }
        return read;
    }

    void write(ObjectNode file) {
        write(SceneSetting.OF_VIEW, file);
        ObjectNode look = JsonNodeFactory.instance.objectNode();
        write(SceneSetting.OF_LOOK, look);
        if (!look.isEmpty()) file.set(LOOK, look);
    }

    private void write(List<SceneSetting<?>> settings, ObjectNode out) {
        for (SceneSetting<?> setting : settings) write(setting, out);
    }

    private <T> void write(SceneSetting<T> setting, ObjectNode out) {
        get(setting).ifPresent(value -> out.set(setting.field(), setting.written(value)));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Settings that && values.equals(that.values);
    }

    @Override
    public int hashCode() {
        return values.hashCode();
    }

    @Override
    public String toString() {
        return values.toString();
    }
}
