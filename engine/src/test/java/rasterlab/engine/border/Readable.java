package rasterlab.engine.border;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.stream.Collectors;

/** Text of inputs whose records hold arrays, with the arrays' numbers. */
final class Readable {
    private Readable() {}

    static String text(Object any) {
        if (any instanceof Record each) return record(each);
        if (any instanceof Iterable<?> each) return list(each);
        if (any != null && any.getClass().isArray()) {
            String array = Arrays.deepToString(new Object[] {any});
            return array.substring(1, array.length() - 1);
        }
        return "" + any;
    }

    private static String record(Record each) {
        return Arrays.stream(each.getClass().getRecordComponents())
                .map(part -> part.getName() + " " + text(value(each, part)))
                .collect(Collectors.joining(", ", "(", ")"));
    }

    private static String list(Iterable<?> each) {
        var parts = new StringBuilder();
        for (Object part : each) parts.append(parts.isEmpty() ? "" : ", ").append(text(part));
        return "[" + parts + "]";
    }

    private static Object value(Record each, RecordComponent part) {
        try {
            part.getAccessor().setAccessible(true);
            return part.getAccessor().invoke(each);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(part + " cannot be read", e);
        }
    }
}
