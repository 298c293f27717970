package rasterlab.exercises.score;

import java.util.Locale;
import java.util.stream.Stream;

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
    /** Nothing was timed, so that nothing can be said; only for the report's line on speed. */
    NOT_MEASURED,
    /**
     * The method was measured, and right, but is worth no point; only for the report's line on
     * speed.
     */
    TOO_SLOW,
    /** The case's turn did not come, for the method was stopped before; only for a case. */
    NOT_RUN,
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

    /** The nearest one that scripts know, and that a whole submission may have. */
    public GradingVerdict published() {
        return switch (this) {
            case NOT_RUN -> NO_RESULT;
            case TOO_SLOW -> OK;
            default -> this;
        };
    }

    /** The verdict in words, the same wherever they are read. */
    public String word(String language) {
        return Message.of("verdict." + code()).in(language);
    }

    /** A verdict's code in words; as it is where it is none that is known here. */
    public static String word(String code, String language) {
        return Stream.of(values())
                .filter(one -> one.code().equals(code))
                .map(one -> one.word(language))
                .findFirst()
                .orElse(code);
    }
}
