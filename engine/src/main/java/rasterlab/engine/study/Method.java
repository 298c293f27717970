package rasterlab.engine.study;

import java.util.regex.Pattern;

/**
 * A named implementation of a contract.
 *
 * @param name lower-case with hyphens; ends in {@code -textbook} for a faulty version kept because
 *     it teaches
 * @param about what the lab's "About this method" shows
 * @param implementation stateless, safe to call from several threads
 * @param <C> the contract
 */
public record Method<C>(String name, About about, C implementation) {
    private static final Pattern NAME = Pattern.compile("[a-z0-9]+(-[a-z0-9]+)*");

    public Method {
        if (!NAME.matcher(name).matches())
            throw new IllegalArgumentException(
                    "method name must be lower-case words with hyphens, got '" + name + "'");
    }

    /** A version with the sources' known faults, kept to be looked at beside the right one. */
    public boolean faulty() {
        return name.endsWith("-textbook");
    }

    /** Whether it promises to be right on all inputs that it does not refuse. */
    public boolean promisesToBeRight() {
        return about.failures().startsWith(About.NO_FAILURE);
    }

    /**
     * The method in a teacher's words, in English; the lab translates.
     *
     * @param formula what is computed, in mathematical notation
     * @param invariant what holds at each step
     * @param cost operations per item
     * @param failures where it is known to fail, or "none known" within its stated range
     * @param source author, title or journal, year
     */
    public record About(
            String formula, String invariant, String cost, String failures, String source) {
        /** How {@link #failures} begins where no input is known that is answered wrongly. */
        private static final String NO_FAILURE = "none known";
    }
}
