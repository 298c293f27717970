package rasterlab.exercises.judging;

import java.util.List;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** Finds what to say of answers without an output, whatever the topic. */
public final class Failure {
    private static final String REFUSAL = IllegalArgumentException.class.getName();
    private static final String OUT_OF_MEMORY = OutOfMemoryError.class.getName();

    private Failure() {}

    /**
     * The finding on an answer without an output.
     *
     * @param mayRefuse whether an IllegalArgumentException is as good as the right answer
     */
    public static Finding of(Answer answer, boolean mayRefuse) {
        return switch (answer.ending()) {
            case THREW -> thrown(answer, mayRefuse);
            case CUT, TOO_LONG -> limit(answer);
            case NULL -> wrong("null", Message.of("answer.null"));
            case OVERWROTE -> wrong("overwrites", Message.of("answer.overwrites"));
            case RETURNED, UNUSABLE ->
                    Finding.of(
                            GradingVerdict.WRONG,
                            answer.explanation().isEmpty()
                                    ? Message.of("answer.unusable", answer.message())
                                    : answer.explanation(),
                            List.of(
                                    List.of(
                                            new Cause(
                                                    "unusable",
                                                    Message.of("answer.unusable.any")))));
        };
    }

    private static Finding thrown(Answer answer, boolean mayRefuse) {
        if (mayRefuse && answer.exception().equals(REFUSAL)) return Finding.OK;
        GradingVerdict verdict =
                answer.exception().equals(OUT_OF_MEMORY)
                        ? GradingVerdict.MEMORY_LIMIT
                        : GradingVerdict.RUNTIME_ERROR;
        return Finding.of(
                verdict,
                Message.of("answer.threw", answer.thrown()).and(answer.place()),
                List.of(List.of(thrownCause(answer.exception()))));
    }

    /** Names it where it is the JDK's; the student's own may tell what it was thrown for. */
    private static Cause thrownCause(String exception) {
        return Answer.isOfTheJdk(exception)
                ? Cause.of("throws", exception)
                : Cause.of("throws-own");
    }

    private static Finding limit(Answer answer) {
        String key =
                answer.ending() == Answer.CallEnding.CUT ? "answer.too-many" : "answer.too-long";
        return Finding.of(GradingVerdict.OUTPUT_LIMIT, Message.of(key));
    }

    private static Finding wrong(String code, Message said) {
        return Finding.of(GradingVerdict.WRONG, said, List.of(List.of(new Cause(code, said))));
    }
}
