package rasterlab.engine.format;

/** An answer that is not waited for to its end, or that is too long to be kept. */
public final class AnswerLimitReached extends RuntimeException {
    private static final long serialVersionUID = 1L;

    public AnswerLimitReached(String message) {
        super(message);
    }
}
