package rasterlab.engine.study;

import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;

/**
 * Copies of what methods are given, so that one that writes into it changes no question.
 *
 * <p>Records, lists and arrays are copied as deep as they go; anything else lets nobody change it,
 * which a test holds for every topic.
 */
final class Inputs {
    private static final ClassValue<Shape> SHAPES =
            new ClassValue<>() {
                @Override
                protected Shape computeValue(Class<?> type) {
                    return Shape.of(type);
                }
            };

    private Inputs() {}

    /** A copy of the input, no array of which is shared; the very same where it has none. */
    static <I> I copy(I input) {
        @SuppressWarnings("unchecked") // a copy has the type of what it copies
        I copy = (I) copyOf(input);
        return copy;
    }

    /**
     * Refuses what a method did to its copy.
     *
     * @throws InputChanged if a number is another one now
     */
    static void requireUnchanged(Object copy, Object input) {
        if (!same(copy, input)) throw new InputChanged();
    }

    private static Object copyOf(Object value) {
        if (value instanceof Record fields) return SHAPES.get(value.getClass()).copy(fields);
        if (value instanceof List<?> items) return copyOf(items);
        return value != null && value.getClass().isArray() ? copyOfArray(value) : value;
    }

    private static List<?> copyOf(List<?> items) {
        List<Object> copies = null;
        for (int i = 0; i < items.size(); i++) {
            Object copy = copyOf(items.get(i));
            if (copy == items.get(i)) continue;
            if (copies == null) copies = Arrays.asList(items.toArray());
            copies.set(i, copy);
        }
        return copies == null ? items : copies;
    }

    private static Object copyOfArray(Object array) {
        int length = Array.getLength(array);
        Object copy = Array.newInstance(array.getClass().getComponentType(), length);
        if (array instanceof Object[] from)
            for (int i = 0; i < length; i++) Array.set(copy, i, copyOf(from[i]));
        else System.arraycopy(array, 0, copy, 0, length);
        return copy;
    }

    private static boolean same(Object a, Object b) {
        if (a == b) return true;
        if (a instanceof Record one) return SHAPES.get(a.getClass()).same(one, (Record) b);
        if (a instanceof List<?> one && b instanceof List<?> other)
            return same(one.toArray(), other.toArray());
        if (a instanceof Object[] one && b instanceof Object[] other) {
            boolean same = one.length == other.length;
            for (int i = 0; same && i < one.length; i++) same = same(one[i], other[i]);
            return same;
        }
        return Arrays.deepEquals(new Object[] {a}, new Object[] {b});
    }

    /**
     * How a record is taken apart and put together.
     *
     * @param fixed whether no value of that type can be changed
     */
    private record Shape(boolean fixed, Method[] parts, Constructor<?> whole) {
        static Shape of(Class<?> type) {
            RecordComponent[] components = type.getRecordComponents();
            Method[] parts =
                    Arrays.stream(components)
                            .map(RecordComponent::getAccessor)
                            .toArray(Method[]::new);
            Class<?>[] types =
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class[]::new);
            try {
                Constructor<?> whole = type.getDeclaredConstructor(types);
                whole.setAccessible(true);
                for (Method part : parts) part.setAccessible(true);
                return new Shape(Arrays.stream(types).allMatch(Shape::isFixed), parts, whole);
            } catch (NoSuchMethodException e) {
                throw new AssertionError("a record has a constructor of all its components", e);
            }
        }

        private static boolean isFixed(Class<?> type) {
            return type.isPrimitive()
                    || type.isEnum()
                    || type == String.class
                    || type.isRecord() && SHAPES.get(type).fixed();
        }

        Record copy(Record record) {
            if (fixed) return record;
            Object[] values = values(record);
            boolean changed = false;
            for (int i = 0; i < values.length; i++) {
                Object copy = copyOf(values[i]);
                changed |= copy != values[i];
                values[i] = copy;
            }
            return changed ? made(values) : record;
        }

        boolean same(Record a, Record b) {
            return fixed ? a.equals(b) : Inputs.same(values(a), values(b));
        }

        private Object[] values(Record record) {
            var values = new Object[parts.length];
            try {
                for (int i = 0; i < parts.length; i++) values[i] = parts[i].invoke(record);
            } catch (ReflectiveOperationException e) {
                throw new AssertionError("a record tells its components: " + record, e);
            }
            return values;
        }

        private Record made(Object[] values) {
            try {
                return (Record) whole.newInstance(values);
            } catch (ReflectiveOperationException e) {
                throw new AssertionError("a record can be made of its own components", e);
            }
        }
    }
}
