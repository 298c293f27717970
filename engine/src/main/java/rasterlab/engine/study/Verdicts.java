package rasterlab.engine.study;

/** The verdict of a call that gave no answer, or none that can be compared. */
final class Verdicts {
    private static final int LONGEST_DETAIL = 300;

    private Verdicts() {}

    static Verdict ofFailure(Guard.CallOutcome<?> outcome) {
        if (outcome instanceof Guard.TimedOut<?> late)
            return verdict(
                    Verdict.Kind.ENDLESS, "no answer within " + late.limit().toMillis() + " ms");
        if (outcome instanceof Guard.Failed<?> threw) {
            Throwable cause = threw.cause();
            if (cause instanceof LimitReached)
                return verdict(Verdict.Kind.ENDLESS, "it " + cause.getMessage());
            if (cause instanceof InputChanged || cause instanceof SharedAnswer)
                return verdict(Verdict.Kind.WRONG, cause.getMessage());
            if (cause instanceof NoAnswer none) return verdict(none.kind(), none.getMessage());
            if (cause instanceof IllegalArgumentException && cause.getMessage() != null)
                return verdict(Verdict.Kind.REFUSED, cause.getMessage());
            return verdict(Verdict.Kind.CRASHED, cause + place(cause));
        }
        throw new AssertionError("an answer was given: " + outcome);
    }

    /** An answer so misshapen that comparing it with the exact one threw {@code cause}. */
    static Verdict ofAnswer(RuntimeException cause) {
        return verdict(
                Verdict.Kind.WRONG, "its answer cannot be compared: " + cause + place(cause));
    }

    private static String place(Throwable cause) {
        StackTraceElement[] trace = cause.getStackTrace();
        return trace.length == 0 ? "" : " at " + trace[0];
    }

    private static Verdict verdict(Verdict.Kind kind, String detail) {
        String line = detail.strip().replaceAll("\\R+", " ");
        return new Verdict(
                kind,
                Deviation.NONE,
                line.length() <= LONGEST_DETAIL ? line : line.substring(0, LONGEST_DETAIL) + "…");
    }
}
