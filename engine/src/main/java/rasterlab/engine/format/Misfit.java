package rasterlab.engine.format;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** An input that is none: says the place, the value and what is allowed. */
public final class Misfit extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final String place;
    private final String reason;

    /**
     * @param place in the input as a JSON pointer, a line and a column, or an option
     */
    public Misfit(String place, String reason) {
        super(place + ": " + reason);
        this.place = place;
        this.reason = reason;
    }

    /** A complaint about the input as a whole. */
    public Misfit(String reason) {
        super(reason);
        place = "";
        this.reason = reason;
    }

    /** A complaint about the input where it is made into something that refuses it. */
    public static Misfit of(IllegalArgumentException refusal) {
        Matcher placed = Refusal.PLACED.matcher(refusal.getMessage());
        if (!placed.matches()) return new Misfit("/", refusal.getMessage());
        String indices = placed.group(2).replace("]", "").replace('[', '/');
        String axis = placed.group(3) == null ? "" : "/" + "xyz".indexOf(placed.group(3));
        return new Misfit("/" + placed.group(1) + indices + axis, placed.group(4));
    }

    /** Where it is; empty for the input as a whole. */
    public String place() {
        return place;
    }

    public String reason() {
        return reason;
    }

    /** Made only where something is refused. */
    private static final class Refusal {
        /** Such as "vertices[3].x must be from …". */
        static final Pattern PLACED =
                Pattern.compile("(\\w+)((?:\\[\\d+])*)(?:\\.([xyz]))? (must .*)", Pattern.DOTALL);
    }
}
