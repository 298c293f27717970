package rasterlab.exercises.score;

import rasterlab.engine.raster.PixelRecording;

/**
 * What a student's method did with one input, as the child told it.
 *
 * @param pixels what it plotted, in order; none where it threw
 * @param exception class name of what it threw, empty where it did not
 * @param message of the exception, cut; may be empty
 * @param printed what it printed, cut
 */
public record Answer(
        Ending ending, PixelRecording pixels, String exception, String message, String printed) {
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
}
