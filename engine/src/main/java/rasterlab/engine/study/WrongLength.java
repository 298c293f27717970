package rasterlab.engine.study;

/** Thrown where a method answers with more or fewer values than were asked for. */
public final class WrongLength extends IllegalStateException {
    private static final long serialVersionUID = 1L;
    private final int asked;
    private final int got;

    private WrongLength(int asked, int got, String message) {
        super(message);
        this.asked = asked;
        this.got = got;
    }

    /**
     * Refuses an answer of another length.
     *
     * @param items what is counted, in the plural
     * @throws WrongLength if it has not as many values as were asked for
     */
    public static void require(int asked, int got, String items) {
        if (got != asked)
            throw new WrongLength(
                    asked, got, "%d %s were asked for, got %d".formatted(asked, items, got));
    }

    public int asked() {
        return asked;
    }

    public int got() {
        return got;
    }
}
