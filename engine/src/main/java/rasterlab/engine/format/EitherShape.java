package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/**
 * A value of one of several shapes, which its beginning tells apart.
 *
 * @param <T> what it becomes
 */
public abstract class EitherShape<T> implements Shape<T> {
    private final List<Shape<?>> shapes;

    protected EitherShape(Shape<?>... shapes) {
        this.shapes = List.of(shapes);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        out.name("anyOf");
        out.startArray();
        for (Shape<?> shape : shapes) shape.schema(out);
        out.endArray();
        out.endObject();
    }

    /** A value that may be missing in its place: null. */
    public static <T> Shape<T> orNull(Shape<T> shape) {
        return new NullableShape<>(shape);
    }
}
