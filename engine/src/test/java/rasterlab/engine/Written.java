package rasterlab.engine;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.stream.Collectors;

/** Everything that an input is made of as text, to compare what it was with what it is. */
final class Written {
    private Written() {}

    static String out(Object value) {
        if (value instanceof double[] numbers) return Arrays.toString(numbers);
        if (value instanceof int[] numbers) return Arrays.toString(numbers);
        if (value instanceof Object[] items) return out(Arrays.asList(items));
        if (value instanceof Iterable<?> items) {
            var text = new StringBuilder();
            for (Object item : items) text.append(out(item)).append(';');
            return text.toString();
        }
        boolean ours =
                value != null
                        && value.getClass().getName().startsWith("rasterlab.")
                        && !(value instanceof Enum<?>);
        return ours ? fields(value) : String.valueOf(value);
    }

    private static String fields(Object value) {
        return Arrays.stream(value.getClass().getDeclaredFields())
                .filter(field -> !Modifier.isStatic(field.getModifiers()))
                .map(field -> field.getName() + "=" + out(read(field, value)))
                .collect(Collectors.joining(", ", "(", ")"));
    }

    private static Object read(Field field, Object of) {
        try {
            field.setAccessible(true);
            return field.get(of);
        } catch (IllegalAccessException e) {
            throw new AssertionError(field + " can be read", e);
        }
    }
}
