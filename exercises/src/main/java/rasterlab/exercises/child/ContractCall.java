package rasterlab.exercises.child;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.PixelGrid;

/**
 * A call of one of a contract's methods on the wire: what the method is given, and what came of it.
 *
 * <p>Given are values ({@link Values}), a picture, and sinks, which are not sent: the child has its
 * own. What came of it is, in this order: the items of each sink and the writings of each picture,
 * the value that was returned, and the given values once more if the method changed any.
 */
public final class ContractCall {
    private final int number;
    private final Method method;
    private final List<Class<?>> given;

    private ContractCall(int number, Method method) {
        this.number = number;
        this.method = method;
        this.given = List.of(method.getParameterTypes());
    }

    /**
     * The calls of a method.
     *
     * @param number of the method in its contract, from 0
     * @throws IllegalArgumentException if it takes or returns what cannot be sent
     */
    static ContractCall of(int number, Method method) {
        for (Class<?> type : method.getParameterTypes())
            if (!Values.carries(type) && !SinkSheets.isKept(type)) throw cannotBeSent(method, type);
        Class<?> returned = method.getReturnType();
        if (returned != void.class && !Values.carries(returned))
            throw cannotBeSent(method, returned);
        return new ContractCall(number, method);
    }

    private static IllegalArgumentException cannotBeSent(Method method, Class<?> type) {
        return new IllegalArgumentException(
                "%s.%s has a %s, which cannot be sent"
                        .formatted(
                                method.getDeclaringClass().getSimpleName(),
                                method.getName(),
                                type.getSimpleName()));
    }

    public int number() {
        return number;
    }

    public Method method() {
        return method;
    }

    /** Writes what the method is given. */
    public void writeArguments(Object[] arguments, DataOutputStream out) throws IOException {
        for (int i = 0; i < arguments.length; i++) {
            if (arguments[i] instanceof PixelGrid picture) GridSheet.write(picture, out);
            else if (!SinkSheets.isKept(given.get(i)))
                Values.write(given.get(i), arguments[i], out);
        }
    }

    /**
     * Reads what the method is given, with fresh sheets for its sinks and pictures.
     *
     * @param most the most items of a sheet
     * @param room for so many items from the start
     */
    Object[] readArguments(DataInputStream in, int most, int room) throws IOException {
        Object[] arguments = new Object[given.size()];
        for (int i = 0; i < arguments.length; i++)
            arguments[i] =
                    SinkSheets.isKept(given.get(i))
                            ? SinkSheets.of(given.get(i), in, most, room)
                            : Values.read(given.get(i), in);
        return arguments;
    }

    /**
     * The bytes of what came of a call.
     *
     * @param before the given values as they were
     * @param held arrays that others hold
     * @throws BoundedBytes.Beyond if there are more than {@code most}
     */
    byte[] answer(byte[] before, List<Object> held, Object[] arguments, Object returned, int most)
            throws IOException {
        var bytes = new BoundedBytes(most);
        DataOutputStream out = new DataOutputStream(bytes);
        for (Object one : arguments) if (one instanceof SinkSheet sheet) sheet.writeTo(out);
        if (returnsValue()) {
            Values.write(method.getReturnType(), returned, out);
            ArrayAliases.write(returned, held, out);
        }
        byte[] after = values(arguments);
        boolean changed = !Arrays.equals(before, after);
        out.writeBoolean(changed);
        if (changed) out.write(after);
        return bytes.toByteArray();
    }

    /**
     * The bytes of what comes of a call in this process, as {@link #replay} takes them.
     *
     * @param implementation swallows no errors
     * @param most the most items of a sheet; what is beyond them is left out
     */
    public byte[] answered(Object implementation, Object[] given, int most) throws Throwable {
        var bytes = new ByteArrayOutputStream();
        writeArguments(given, new DataOutputStream(bytes));
        var in = new DataInputStream(new ByteArrayInputStream(bytes.toByteArray()));
        Object[] arguments = readArguments(in, most, Math.min(most, SinkSheet.USUAL));
        byte[] before = values(arguments);
        List<Object> held = new ArrayAliases().before(this, arguments);
        Object returned = null;
        try {
            returned = invoke(implementation, arguments);
        } catch (Throwable stopped) {
            if (!SinkSheet.isAnyFull(arguments)) throw stopped;
        }
        return answer(before, held, arguments, returned, Wire.MOST_ANSWER_BYTES);
    }

    /**
     * The given values alone, as they are written.
     *
     * @throws BoundedBytes.Beyond if the method put something into them that is longer than what is
     *     taken
     */
    byte[] values(Object[] arguments) throws IOException {
        var bytes = new BoundedBytes(Wire.MOST_FRAME_BYTES);
        DataOutputStream out = new DataOutputStream(bytes);
        for (int i = 0; i < arguments.length; i++)
            if (!SinkSheets.isKept(given.get(i))) Values.write(given.get(i), arguments[i], out);
        return bytes.toByteArray();
    }

    /**
     * Adds what came of a call to a sum.
     *
     * @throws BoundedBytes.Beyond if its value has more than {@code most} bytes
     */
    void addTo(ItemSum sum, Object[] arguments, Object returned, int most) throws IOException {
        for (Object one : arguments) if (one instanceof SinkSheet sheet) sheet.addTo(sum);
        if (!returnsValue() && hasSheets()) return;
        var bytes = new BoundedBytes(most);
        DataOutputStream out = new DataOutputStream(bytes);
        if (returnsValue()) Values.write(method.getReturnType(), returned, out);
        else out.write(values(arguments));
        sum.add(longs(bytes.toByteArray()));
    }

    private boolean hasSheets() {
        return given.stream().anyMatch(SinkSheets::isKept);
    }

    private static long[] longs(byte[] bytes) {
        long[] longs = new long[(bytes.length + Long.BYTES - 1) / Long.BYTES];
        for (int i = 0; i < bytes.length; i++)
            longs[i / Long.BYTES] = longs[i / Long.BYTES] << Byte.SIZE | bytes[i] & 0xFF;
        return longs;
    }

    /**
     * The outcome of a call.
     *
     * @param value that it returned; null where it returns nothing, and where it returned null
     * @param items that it sent to sinks, and 1 for a value
     * @param spoilt whether it wrote into what it was given what cannot stand there
     */
    public record Done(Object value, int items, boolean spoilt) {}

    /**
     * Does to the arguments what the method did to those in the child: sends the items to its
     * sinks, writes into its pictures and changes its arrays.
     *
     * @param arrays that are held here; the answer's come to them
     * @throws IOException if the bytes are no answer
     */
    public Done replay(DataInputStream in, Object[] arguments, ArrayAliases arrays)
            throws IOException {
        List<Object> held = arrays.before(this, arguments);
        int items = 0;
        for (int i = 0; i < arguments.length; i++)
            if (SinkSheets.isKept(given.get(i)))
                items += SinkSheets.replay(given.get(i), in, arguments[i]);
        Object value = null;
        if (returnsValue()) {
            value = ArrayAliases.read(Values.read(method.getReturnType(), in), held, in);
            arrays.after(this, value);
        }
        boolean spoilt = in.readBoolean() && !copied(in, arguments);
        return new Done(value, value == null ? items : items + 1, spoilt);
    }

    /** Copies what was changed; false where a changed record refuses its numbers. */
    private boolean copied(DataInputStream in, Object[] arguments) {
        try {
            for (int i = 0; i < arguments.length; i++)
                if (!SinkSheets.isKept(given.get(i)))
                    Values.copy(Values.read(given.get(i), in), arguments[i]);
            return true;
        } catch (IOException refused) {
            return false;
        }
    }

    public boolean returnsValue() {
        return method.getReturnType() != void.class;
    }

    /** Calls a method of the contract in this process. */
    public Object invoke(Object implementation, Object[] arguments) throws Throwable {
        try {
            return method.invoke(implementation, arguments);
        } catch (InvocationTargetException e) {
            throw e.getCause();
        }
    }
}
