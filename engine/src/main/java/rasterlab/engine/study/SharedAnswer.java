package rasterlab.engine.study;

/**
 * Thrown where a contract promises a new array and a method answers with one that somebody else
 * holds: whoever writes into it would change another's numbers.
 */
public final class SharedAnswer extends IllegalStateException {
    private static final long serialVersionUID = 1L;

    private final boolean given;

    private SharedAnswer(boolean given, String message) {
        super(message);
        this.given = given;
    }

    /** Whether it is an array that the method was given; else one that it answered before. */
    public boolean given() {
        return given;
    }

    /**
     * Refuses an answer that is not the caller's own.
     *
     * @param given what the method was given
     * @param again what it answered when it was asked the same once more
     * @throws SharedAnswer if the answer is one of the two
     */
    public static void requireNew(Object answer, Object given, Object again) {
        if (answer != null && answer == given)
            throw new SharedAnswer(
                    true, "its answer is the array that it was given, not a new one");
        if (answer != null && answer == again)
            throw new SharedAnswer(
                    false, "its answer is the same array at every call, not a new one");
    }
}
