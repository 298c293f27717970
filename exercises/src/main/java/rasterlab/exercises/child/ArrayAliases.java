package rasterlab.exercises.child;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * The arrays that others hold while a method answers: those that it is given, and those of its last
 * answer. An answer tells which of its arrays are such, so that a promise of a new one can be
 * checked where the answer arrives.
 */
public final class ArrayAliases {
    private final Map<Integer, List<Object>> last = new HashMap<>();

    /** Forgets the answers: nobody holds them any more. */
    void forget() {
        last.clear();
    }

    /** The arrays held before a call; parent and child find them in the same order. */
    List<Object> before(ContractCall call, Object[] given) {
        List<Object> held = within(given);
        held.addAll(last.getOrDefault(call.number(), List.of()));
        return held;
    }

    void after(ContractCall call, Object returned) {
        last.put(call.number(), within(returned));
    }

    private static List<Object> within(Object... values) {
        List<Object> found = new ArrayList<>();
        for (Object value : values) add(value, found);
        return found;
    }

    private static void add(Object value, List<Object> found) {
        if (value == null || !value.getClass().isArray()) return;
        found.add(value);
        if (value instanceof Object[] items) for (Object item : items) add(item, found);
    }

    /** Writes for each array of an answer the number of the held one that it is, or 0. */
    static void write(Object returned, List<Object> held, DataOutputStream out) throws IOException {
        Map<Object, Integer> numbers = new IdentityHashMap<>();
        for (Object array : held) numbers.putIfAbsent(array, numbers.size() + 1);
        for (Object array : within(returned)) out.writeInt(numbers.getOrDefault(array, 0));
    }

    /**
     * Puts the held arrays into the place of those that are such.
     *
     * @throws IOException if the bytes do not say that
     */
    static Object read(Object value, List<Object> held, DataInputStream in) throws IOException {
        List<Object> known = new ArrayList<>();
        Map<Object, Integer> numbers = new IdentityHashMap<>();
        for (Object array : held)
            if (numbers.putIfAbsent(array, numbers.size() + 1) == null) known.add(array);
        return replaced(value, known, in);
    }

    private static Object replaced(Object value, List<Object> known, DataInputStream in)
            throws IOException {
        if (value == null || !value.getClass().isArray()) return value;
        int number = in.readInt();
        if (value instanceof Object[] items)
            for (int i = 0; i < items.length; i++) items[i] = replaced(items[i], known, in);
        if (number == 0) return value;
        if (number < 0 || number > known.size())
            throw new IOException("array " + number + " of " + known.size());
        Object array = known.get(number - 1);
        int length = Array.getLength(value);
        if (array.getClass() != value.getClass() || Array.getLength(array) != length)
            throw new IOException("array " + number + " is another");
        System.arraycopy(value, 0, array, 0, length);
        return array;
    }
}
