package rasterlab.exercises.score;

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

    /** The exception's class and message as one text. */
    public String thrown() {
        return message.isEmpty() ? exception : exception + ": " + message;
    }

    /** In which line that was; nothing where none is known. */
    public Message place() {
        return line > 0 ? Message.of("thrown.line", line) : Message.NONE;
    }
}
