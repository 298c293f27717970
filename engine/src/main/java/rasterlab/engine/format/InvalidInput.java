package rasterlab.engine.format;

/** An input that is none: says the place, the value and what is allowed. */
public final class InvalidInput extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final String place;
    private final String reason;

    /**
     * @param place in the input as a JSON pointer, a line and a column, or an option
     */
    public InvalidInput(String place, String reason) {
        super(place + ": " + reason);
        this.place = place;
        this.reason = reason;
    }

    /** A complaint about the input as a whole. */
    public InvalidInput(String reason) {
        super(reason);
        place = "";
        this.reason = reason;
    }

    /** Where it is; empty for the input as a whole. */
    public String place() {
        return place;
    }

    public String reason() {
        return reason;
    }
}
