package rasterlab.exercises.score;

/**
 * A case's verdict as scripts are told it. To them a case that was not run has no result, and a
 * speed that is worth nothing is right: both were so before they had words of their own.
 *
 * @param code of a verdict; of a server's it may be none that is known here
 * @param run whether the case was run
 */
public record PublishedVerdict(String code, boolean run) {
    public static PublishedVerdict of(GradingVerdict verdict) {
        return new PublishedVerdict(verdict.published().code(), verdict != GradingVerdict.NOT_RUN);
    }

    /**
     * The code of the case's own verdict.
     *
     * @param points earned by the case
     * @param of the most it can earn
     */
    public String codeFor(int points, int of) {
        if (!run) return GradingVerdict.NOT_RUN.code();
        boolean worthless = code.equals(GradingVerdict.OK.code()) && points == 0 && of > 0;
        return worthless ? GradingVerdict.TOO_SLOW.code() : code;
    }
}
