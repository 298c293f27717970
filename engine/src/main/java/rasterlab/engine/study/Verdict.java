package rasterlab.engine.study;

import java.util.Locale;

/**
 * The outcome of a method for a hazard.
 *
 * @param kind which of the six answers
 * @param deviation how far from exact; {@link Deviation#NONE} where there is no answer to compare
 * @param detail one line for people: the refusal's message, the exception's name, the first
 *     difference; may be empty
 */
public record Verdict(Kind kind, Deviation deviation, String detail) {
    /** The six answers, best first. */
    public enum Kind {
        EXACT,
        /** The answer is not exact, but within what the topic calls usable. */
        DEGRADED,
        WRONG,
        /** The method said that it cannot: an answer, never rubbish. */
        REFUSED,
        ENDLESS,
        CRASHED;

        /** Lower-case name, as printed and stored. */
        public String code() {
            return name().toLowerCase(Locale.ROOT);
        }
    }
}
