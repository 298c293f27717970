package rasterlab.app.cli.run.json;

import java.io.IOException;

/**
 * One field of a JSON object.
 *
 * @param reader reads the value; the input stands on its first token
 * @param required whether an object without it is refused
 * @param <T> what the value becomes
 */
public record JsonField<T>(String name, Reader<T> reader, boolean required) {
    /** Reads one value. */
    @FunctionalInterface
    public interface Reader<T> {
        T read(StrictJson json) throws IOException;
    }

    public static <T> JsonField<T> required(String name, Reader<T> reader) {
        return new JsonField<>(name, reader, true);
    }

    public static <T> JsonField<T> optional(String name, Reader<T> reader) {
        return new JsonField<>(name, reader, false);
    }
}
