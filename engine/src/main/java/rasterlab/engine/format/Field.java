package rasterlab.engine.format;

import java.io.IOException;

/**
 * One field of an object.
 *
 * @param required whether an object without it is refused
 * @param kind what its value is where it is drawn
 * @param unit of its numbers in the plural, such as "degrees"; empty where they have none
 * @param <T> what its value becomes
 */
public record Field<T>(String name, Shape<T> shape, boolean required, FieldKind kind, String unit) {
    public static <T> Field<T> required(String name, Shape<T> shape) {
        return new Field<>(name, shape, true, FieldKind.NUMBERS, "");
    }

    public static <T> Field<T> optional(String name, Shape<T> shape) {
        return new Field<>(name, shape, false, FieldKind.NUMBERS, "");
    }

    /** This field, whose value is drawn as that. */
    public Field<T> as(FieldKind drawn) {
        return new Field<>(name, shape, required, drawn, unit);
    }

    /**
     * This field, whose numbers are in a unit.
     *
     * @param plural such as "degrees"
     */
    public Field<T> in(String plural) {
        return new Field<>(name, shape, required, kind, plural);
    }

    /** Writes the schema of its values: that of the shape, with the unit. */
    void schema(ValueSink out) throws IOException {
        shape.schema(unit.isEmpty() ? out : new DescribedSchema(out, "in " + unit));
    }
}
