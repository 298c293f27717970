package rasterlab.engine;

import java.lang.reflect.Array;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;

/**
 * A method of any contract that overwrites every array it is given, with numbers that make an easy
 * input, and then does what a right method does.
 */
final class Vandal {
    private final AtomicBoolean found = new AtomicBoolean();
    private final Object right;

    /**
     * @param right a method, which implements one contract
     */
    Vandal(Object right) {
        this.right = right;
    }

    /** Whether there was anything to overwrite. */
    boolean foundSomething() {
        return found.get();
    }

    /** The method, of the contract {@code C}. */
    @SuppressWarnings("unchecked") // the proxy implements what the right method implements
    <C> C method() {
        Class<?> contract = contract(right.getClass());
        return (C)
                Proxy.newProxyInstance(
                        contract.getClassLoader(),
                        new Class<?>[] {contract},
                        (proxy, called, given) -> {
                            if (given != null) for (Object each : given) overwrite(each);
                            try {
                                called.setAccessible(true);
                                return called.invoke(right, given);
                            } catch (InvocationTargetException e) {
                                throw e.getCause();
                            }
                        });
    }

    private static Class<?> contract(Class<?> type) {
        return interfaces(type)
                .filter(
                        each ->
                                each.getName().startsWith("rasterlab.contract.")
                                        || each.getSimpleName().equals("Visibility"))
                .findFirst()
                .orElseThrow(() -> new AssertionError(type + " implements no contract"));
    }

    private static Stream<Class<?>> interfaces(Class<?> type) {
        if (type == null) return Stream.of();
        Stream<Class<?>> own = Stream.of(type.getInterfaces());
        return Stream.concat(
                own.flatMap(each -> Stream.concat(Stream.of(each), interfaces(each))),
                interfaces(type.getSuperclass()));
    }

    private void overwrite(Object value) throws ReflectiveOperationException {
        if (value instanceof List<?> items) for (Object item : items) overwrite(item);
        if (value instanceof Object[] items) for (Object item : items) overwrite(item);
        if (value instanceof Record)
            for (RecordComponent part : value.getClass().getRecordComponents()) {
                part.getAccessor().setAccessible(true);
                overwrite(part.getAccessor().invoke(value));
            }
        if (value == null || !value.getClass().isArray()) return;
        if (value.getClass().getComponentType().isPrimitive()) fill(value);
    }

    /** 1, 2, 4, … of thousandths, or 0, 1, 2, 0, … in an array of whole numbers. */
    private void fill(Object numbers) {
        for (int i = 0; i < Array.getLength(numbers); i++) {
            if (numbers instanceof double[] doubles) doubles[i] = 0.001 * (1 << i % 10);
            else if (numbers instanceof int[] ints) ints[i] = i % 3;
            else throw new AssertionError("cannot overwrite " + numbers);
            found.set(true);
        }
    }
}
