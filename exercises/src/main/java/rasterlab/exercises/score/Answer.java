package rasterlab.exercises.score;

import java.util.stream.Stream;
import rasterlab.engine.raster.PixelRecording;

/**
 * What a student's method did with one input, as the child told it.
 *
 * @param pixels what it plotted, in order; none where it threw
 * @param exception class name of what it threw, empty where it did not
 * @param message of the exception, cut; may be empty
 * @param line of the source where the exception was thrown, from 1; 0 where none is known
 * @param printed what it printed, cut
 */
public record Answer(
        Ending ending,
        PixelRecording pixels,
        String exception,
        String message,
        int line,
        String printed) {
    /** How the call ended. */
    public enum Ending {
        RETURNED,
        /** Stopped, because it went on plotting beyond the limit. */
        CUT,
        THREW
    }

    /** Whether both ended alike and plotted the same pixels in the same order. */
    public boolean isSameAs(Answer other) {
        if (ending != other.ending
                || !exception.equals(other.exception)
                || pixels.size() != other.pixels.size()) return false;
        for (int i = 0; i < pixels.size(); i++)
            if (pixels.x(i) != other.pixels.x(i) || pixels.y(i) != other.pixels.y(i)) return false;
        return true;
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

    /** In which line that was; nothing where none is known. */
    public Message place() {
        return line > 0 ? Message.of("thrown.line", line) : Message.NONE;
    }
}
