package rasterlab.exercises.score;

import java.util.Locale;

/** The answer to a submission, or to one case of it. */
public enum GradingVerdict {
    OK,
    WRONG,
    COMPILE_ERROR,
    /** The source or its byte code uses something that the exercise does not allow. */
    REFUSED,
    TIME_LIMIT,
    MEMORY_LIMIT,
    OUTPUT_LIMIT,
    RUNTIME_ERROR,
    /** The child ended early or broke the protocol. */
    NO_RESULT,
    /** Only for the report's line on speed: nothing was timed, so that nothing can be said. */
    NOT_MEASURED,
    /** Our own fault: tried again, never a mark. */
    INTERNAL;

    /** The class of the error, for a case whose input stays hidden; nothing when right. */
    Message hint() {
        return this == OK ? Message.NONE : Message.of("hidden." + code());
    }

    /** Lower-case name, as in the HTTP API. */
    public String code() {
        return name().toLowerCase(Locale.ROOT);
    }
}
