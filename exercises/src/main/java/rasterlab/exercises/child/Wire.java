package rasterlab.exercises.child;

/**
 * The words of the protocol between parent and child.
 *
 * <p>Each request begins with an operation (byte) and a nonce (long); each answer begins with that
 * nonce and a status (byte). All numbers are big-endian, as {@link java.io.DataOutput} writes them.
 */
public final class Wire {
    /** No payload; answered by {@link #DONE}. */
    public static final int PING = 0;

    /** Source as UTF-8 bytes. */
    public static final int COMPILE = 1;

    /**
     * Name of the contract, the classes that call its methods as a frame each, name of the class to
     * make an instance of, number of classes, then name and bytes of each.
     */
    public static final int LOAD = 2;

    /**
     * Whether it is the first call for an input (boolean), the most items of a sink (int), the most
     * bytes of the answer (int), the number of the method (int) and what it is given; answered by
     * what came of it as a frame ({@link ContractCall}) and what was printed.
     */
    public static final int CALL = 3;

    /**
     * Number of calls, the most items of a sink, the most bytes of an answer, the usual number of
     * items, the first call to be told in full and the one after the last (six ints), then the
     * number of the method (int) and what it is given in each; answered by the nanoseconds that
     * they took, the number of items, their sum and the number of bytes that were printed (four
     * longs), and what came of those calls as a frame each.
     */
    public static final int TIME = 4;

    /** Payload depends on the operation. */
    public static final int DONE = 0;

    /**
     * The payload of DONE, of a method that went on beyond the most items and was stopped; none
     * where it was timed.
     */
    public static final int CUT = 1;

    /** Class name of an exception; a {@link #MESSAGE} with the same nonce follows. */
    public static final int THREW = 2;

    /**
     * The text of the exception, what was printed, and the line of the source where it was thrown
     * (int, 0 where none is known).
     */
    public static final int MESSAGE = 3;

    /** Number of compiler messages, then line, column and text of each. */
    public static final int COMPILER_ERRORS = 4;

    /** The compiler gave up: stack or memory. */
    public static final int TOO_COMPLEX = 5;

    /** The contract has no class of that kind: abstract, without constructor, of another type. */
    public static final int NOT_LOADABLE = 6;

    /** More classes than {@link #MOST_CLASSES}: their number. */
    public static final int TOO_MANY_CLASSES = 7;

    /** Class files longer than {@link #MOST_CLASS_BYTES} together: their length in bytes. */
    public static final int CLASSES_TOO_LONG = 8;

    /**
     * The answer has more bytes than are taken; an empty frame and what was printed follow, or
     * nothing where it was timed.
     */
    public static final int TOO_LONG = 9;

    /** Exit status of a JVM that ran out of memory with -XX:+ExitOnOutOfMemoryError. */
    public static final int EXIT_MEMORY = 3;

    /** Exit status after too much printing, or going on after the limit. */
    public static final int EXIT_OUTPUT = 65;

    /** Exit status after a request that cannot be read. */
    public static final int EXIT_PROTOCOL = 66;

    /** The name of the student's source in class files. */
    public static final String SOURCE_FILE = "Submission.java";

    public static final int MOST_CLASSES = 200;

    /** The most bytes of all class files of a source together. */
    public static final int MOST_CLASS_BYTES = 2 << 20;

    public static final int MOST_FRAME_BYTES = 4 << 20;
    public static final int MOST_ITEMS = 1 << 16;

    /** Leaves room for what was printed. */
    public static final int MOST_ANSWER_BYTES = MOST_FRAME_BYTES - (64 << 10);

    public static final int MOST_PRINTED_BYTES = 64 * 1024;

    /** Characters of a printed text, compiler message or exception text that are passed on. */
    public static final int MOST_SHOWN = 500;

    private Wire() {}

    /** The text's beginning, with "…" where something was cut off. */
    public static String cut(String text) {
        if (text.length() <= MOST_SHOWN) return text;
        boolean insideCharacter = Character.isHighSurrogate(text.charAt(MOST_SHOWN - 1));
        return text.substring(0, insideCharacter ? MOST_SHOWN - 1 : MOST_SHOWN) + "…";
    }
}
