package rasterlab.engine.study;

import java.util.regex.Pattern;

/**
 * A named implementation of a contract. What a teacher says about it stands in the lab's texts,
 * under its name.
 *
 * @param name lower-case with hyphens; ends in {@code -textbook} for a faulty version kept because
 *     it teaches
 * @param promisesToBeRight whether it is right on all inputs that it does not refuse
 * @param implementation stateless, safe to call from several threads
 * @param <C> the contract
 */
public record Method<C>(String name, boolean promisesToBeRight, C implementation) {
    private static final Pattern NAME = Pattern.compile("[a-z0-9]+(-[a-z0-9]+)*");

    public Method {
        if (!NAME.matcher(name).matches())
            throw new IllegalArgumentException(
                    "method name must be lower-case words with hyphens, got '" + name + "'");
    }

    /** A method that promises to be right: its text on failures begins with "none known". */
    public static <C> Method<C> right(String name, C implementation) {
        return new Method<>(name, true, implementation);
    }

    /** A method of which inputs are known that it answers wrongly. */
    public static <C> Method<C> failing(String name, C implementation) {
        return new Method<>(name, false, implementation);
    }

    /** A version with the sources' known faults, kept to be looked at beside the right one. */
    public boolean faulty() {
        return name.endsWith("-textbook");
    }
}
