package rasterlab.exercises.score;

import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.engine.range.Bounds;

/**
 * The result of a student's method for one input, as the child told it.
 *
 * @param output of the topic; empty where there is none
 * @param items number of items of the output
 * @param digest a digest of all that the child told of the output
 * @param exception class name of what it threw, empty where it did not
 * @param message of the exception, cut, or what is wrong with an answer that cannot be used; may be
 *     empty
 * @param line of the source where the exception was thrown, from 1; 0 where none is known
 * @param printed what it printed, cut
 * @param explanation why the answer cannot be used, where words of ours tell that
 */
public record Answer(
        CallEnding ending,
        Optional<Object> output,
        long items,
        String digest,
        String exception,
        String message,
        int line,
        String printed,
        Message explanation) {
    public Answer {
        Bounds.requireAtLeast("line", line, 0);
    }

    /** The ways in which a call ends. */
    public enum CallEnding {
        RETURNED,
        /** The method was stopped because it went on beyond the limit of items. */
        CUT,
        /** The method's answer has more bytes than are taken. */
        TOO_LONG,
        /** The method returned null. */
        NULL,
        /** The method wrote into what it was only given to read. */
        OVERWROTE,
        /** The method returned no answer to this input, such as too few numbers. */
        UNUSABLE,
        THREW
    }

    /** An answer with an output. */
    public static Answer with(
            CallEnding ending, Object output, long items, String told, String printed) {
        return new Answer(
                ending, Optional.of(output), items, told, "", "", 0, printed, Message.NONE);
    }

    /** An answer without an output. */
    public static Answer without(CallEnding ending, String told, String message, String printed) {
        return new Answer(ending, Optional.empty(), 0, told, "", message, 0, printed, Message.NONE);
    }

    /** An answer that cannot be used, for a reason in our own words. */
    public static Answer unusable(String told, Message said, String printed) {
        return new Answer(CallEnding.UNUSABLE, Optional.empty(), 0, told, "", "", 0, printed, said);
    }

    /** The end of a method that threw something. */
    public static Answer threw(String exception, String message, int line, String printed) {
        return new Answer(
                CallEnding.THREW,
                Optional.empty(),
                0,
                "",
                exception,
                message,
                line,
                printed,
                Message.NONE);
    }

    /** Whether both ended alike and told the same, in the same order. */
    public boolean isSameAs(Answer other) {
        return ending == other.ending
                && exception.equals(other.exception)
                && digest.equals(other.digest);
    }

    /** The exception's class and message as one text. */
    public String thrown() {
        return message.isEmpty() ? exception : exception + ": " + message;
    }

    /**
     * Whether the JDK has all classes of that name, so that it tells nothing but the kind of fault.
     *
     * @param exception class name; of a fault in an initialiser several, with colons between
     */
    public static boolean isOfTheJdk(String exception) {
        return Stream.of(exception.split(": ")).allMatch(one -> one.startsWith("java."));
    }

    /** The line in which that was; nothing where none is known. */
    public Message place() {
        return line > 0 ? Message.of("thrown.line", line) : Message.NONE;
    }
}
