package rasterlab.exercises.score;

import java.util.Locale;

/** How much of a case a student sees. */
public enum Disclosure {
    OPEN,
    /** Name and the class of the error only. */
    VERDICT_ONLY,
    AFTER_DEADLINE,
    NEVER;

    /** Lower-case words with hyphens, as in files and in the HTTP API. */
    public String code() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
