package rasterlab.engine.format;

/**
 * One field of an object.
 *
 * @param required whether an object without it is refused
 * @param <T> what its value becomes
 */
public record Field<T>(String name, Shape<T> shape, boolean required) {
    public static <T> Field<T> required(String name, Shape<T> shape) {
        return new Field<>(name, shape, true);
    }

    public static <T> Field<T> optional(String name, Shape<T> shape) {
        return new Field<>(name, shape, false);
    }
}
