package rasterlab.app.cli.run;

import java.lang.reflect.Array;
import java.lang.reflect.Field;
import java.lang.reflect.Modifier;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/** Finds where two values differ, the numbers of arrays and of all their parts included. */
final class SameParts {
    private SameParts() {}

    /** The place of the first difference; empty where both are the same. */
    static Optional<String> difference(Object a, Object b) {
        return difference("", a, b);
    }

    private static Optional<String> difference(String place, Object a, Object b) {
        if (a == null || b == null || a.getClass() != b.getClass() && !(a instanceof List))
            return a == b ? Optional.empty() : differs(place, a, b);
        if (a instanceof List<?> one)
            return difference(place, one.toArray(), ((List<?>) b).toArray());
        if (a.getClass().isArray()) return arrays(place, a, b);
        boolean ours = a.getClass().getName().startsWith("rasterlab.") && !(a instanceof Enum);
        if (!ours) return Objects.equals(a, b) ? Optional.empty() : differs(place, a, b);
        return Arrays.stream(a.getClass().getDeclaredFields())
                .filter(field -> !Modifier.isStatic(field.getModifiers()))
                .map(
                        field ->
                                difference(
                                        place + "." + field.getName(),
                                        value(field, a),
                                        value(field, b)))
                .flatMap(Optional::stream)
                .findFirst();
    }

    private static Optional<String> arrays(String place, Object a, Object b) {
        int length = Array.getLength(a);
        if (length != Array.getLength(b))
            return differs(place + ".length", length, Array.getLength(b));
        for (int i = 0; i < length; i++) {
            Optional<String> found =
                    difference(place + "[" + i + "]", Array.get(a, i), Array.get(b, i));
            if (found.isPresent()) return found;
        }
        return Optional.empty();
    }

    private static Optional<String> differs(String place, Object a, Object b) {
        return Optional.of(place + ": " + a + " and " + b);
    }

    private static Object value(Field field, Object of) {
        try {
            field.setAccessible(true);
            return field.get(of);
        } catch (IllegalAccessException e) {
            throw new AssertionError(e);
        }
    }
}
