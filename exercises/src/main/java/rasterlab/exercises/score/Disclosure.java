package rasterlab.exercises.score;

import java.util.Locale;

/** How much of a case a student sees. */
public enum Disclosure {
    OPEN,
    /** Name and the class of the error only, after the deadline too. */
    VERDICT_ONLY,
    /** Name and the class of the error only, until the deadline has passed. */
    AFTER_DEADLINE,
    /** Nothing is shown, not even the name. */
    NEVER;

    /** Lower-case words with hyphens, as in files and in the HTTP API. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
