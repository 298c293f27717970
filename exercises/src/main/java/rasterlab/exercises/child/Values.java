package rasterlab.exercises.child;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.lang.reflect.Array;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/**
 * Values on the wire: numbers, booleans, texts, enums, records, and arrays of any of these.
 *
 * <p>A value is written as its declared type says, without names. All but numbers and booleans may
 * be null, which a byte before them tells.
 */
public final class Values {
    private Values() {}

    /** Whether values of that type can be sent. */
    static boolean carries(Class<?> type) {
        return carries(type, List.of());
    }

    /**
     * @param around the records that it is in: one within itself would have no end
     */
    private static boolean carries(Class<?> type, List<Class<?>> around) {
        if (type.isArray()) return carries(type.getComponentType(), around);
        if (type.isRecord()) {
            List<Class<?>> inner = new ArrayList<>(around);
            inner.add(type);
            return !around.contains(type)
                    && Stream.of(type.getRecordComponents())
                            .allMatch(part -> carries(part.getType(), inner));
        }
        return type.isPrimitive() && type != void.class || type.isEnum() || type == String.class;
    }

    /**
     * @param type that the contract declares; {@link #carries} it
     * @throws BoundedBytes.Beyond if it is longer than a frame, or than {@code out} takes
     */
    static void write(Class<?> type, Object value, DataOutputStream out) throws IOException {
        if (type.isPrimitive()) {
            writeNumber(value, out);
            return;
        }
        out.writeBoolean(value != null);
        if (value == null) return;
        if (type.isArray()) {
            int length = Array.getLength(value);
            requireRoom(length);
            out.writeInt(length);
            for (int i = 0; i < length; i++)
                write(type.getComponentType(), Array.get(value, i), out);
        } else if (type.isRecord()) {
            for (RecordComponent part : type.getRecordComponents())
                write(part.getType(), partOf(value, part), out);
        } else if (type.isEnum()) {
            out.writeInt(((Enum<?>) value).ordinal());
        } else {
            requireRoom(((String) value).length());
            byte[] text = ((String) value).getBytes(StandardCharsets.UTF_8);
            out.writeInt(text.length);
            out.write(text);
        }
    }

    /** Whether there is null within an array. */
    public static boolean hasNull(Object value) {
        return value instanceof Object[] items
                && Arrays.stream(items).anyMatch(one -> one == null || hasNull(one));
    }

    /** Refuses what is too long before a copy of it is made. */
    private static void requireRoom(int items) throws BoundedBytes.Beyond {
        if (items > Wire.MOST_FRAME_BYTES) throw new BoundedBytes.Beyond();
    }

    private static void writeNumber(Object value, DataOutputStream out) throws IOException {
        if (value instanceof Integer number) out.writeInt(number);
        else if (value instanceof Double number) out.writeDouble(number);
        else if (value instanceof Boolean flag) out.writeBoolean(flag);
        else if (value instanceof Long number) out.writeLong(number);
        else if (value instanceof Float number) out.writeFloat(number);
        else if (value instanceof Short number) out.writeShort(number);
        else if (value instanceof Character letter) out.writeChar(letter);
        else out.writeByte((Byte) value);
    }

    /**
     * Reads what {@link #write} wrote.
     *
     * @throws IOException if the bytes are none of that type; lengths are checked against what
     *     there is before anything is made
     */
    static Object read(Class<?> type, DataInputStream in) throws IOException {
        if (type.isPrimitive()) return readNumber(type, in);
        if (!in.readBoolean()) return null;
        if (type.isArray()) return readArray(type.getComponentType(), in);
        if (type.isRecord()) return readRecord(type, in);
        if (type.isEnum()) {
            Object[] all = type.getEnumConstants();
            int ordinal = in.readInt();
            if (ordinal < 0 || ordinal >= all.length)
                throw new IOException("constant " + ordinal + " of " + all.length);
            return all[ordinal];
        }
        return new String(in.readNBytes(length(in, 1)), StandardCharsets.UTF_8);
    }

    private static Object readNumber(Class<?> type, DataInputStream in) throws IOException {
        if (type == int.class) return in.readInt();
        if (type == double.class) return in.readDouble();
        if (type == boolean.class) return in.readBoolean();
        if (type == long.class) return in.readLong();
        if (type == float.class) return in.readFloat();
        if (type == short.class) return in.readShort();
        if (type == char.class) return in.readChar();
        return in.readByte();
    }

    private static Object readArray(Class<?> type, DataInputStream in) throws IOException {
        Object array = Array.newInstance(type, length(in, leastBytes(type)));
        for (int i = 0; i < Array.getLength(array); i++) Array.set(array, i, read(type, in));
        return array;
    }

    /** A number of items, each of so many bytes at least. */
    static int length(DataInputStream in, int bytes) throws IOException {
        int length = in.readInt();
        if (length < 0 || length > in.available() / bytes)
            throw new IOException(length + " items announced, " + in.available() + " bytes left");
        return length;
    }

    private static int leastBytes(Class<?> type) {
        if (type == double.class || type == long.class) return Long.BYTES;
        return type == int.class || type == float.class ? Integer.BYTES : 1;
    }

    private static Object readRecord(Class<?> type, DataInputStream in) throws IOException {
        RecordComponent[] parts = type.getRecordComponents();
        Object[] values = new Object[parts.length];
        for (int i = 0; i < parts.length; i++) values[i] = read(parts[i].getType(), in);
        Class<?>[] types =
                Arrays.stream(parts).map(RecordComponent::getType).toArray(Class<?>[]::new);
        try {
            return type.getConstructor(types).newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new IOException("no " + type.getSimpleName() + " can be made of that", e);
        }
    }

    private static Object partOf(Object whole, RecordComponent part) {
        try {
            return part.getAccessor().invoke(whole);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError("a contract's record tells its components: " + whole, e);
        }
    }

    /** Makes all numbers in {@code into}'s arrays those of a value with arrays just as long. */
    static void copy(Object from, Object into) {
        if (from instanceof Record && into instanceof Record) {
            for (RecordComponent part : from.getClass().getRecordComponents())
                copy(partOf(from, part), partOf(into, part));
        } else if (from instanceof Object[] some && into instanceof Object[] others) {
            System.arraycopy(some, 0, others, 0, some.length);
        } else if (from != null && from.getClass().isArray()) {
            System.arraycopy(from, 0, into, 0, Array.getLength(from));
        }
    }
}
