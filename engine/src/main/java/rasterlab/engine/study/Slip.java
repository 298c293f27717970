package rasterlab.engine.study;

import java.util.List;

/**
 * A mistake that only a wrong answer shows, as the answer of a right method that was changed.
 *
 * <p>Unlike a {@link Mutant} it has no hazard of its own: no list shows it and nobody is asked to
 * break it. It lets a wrong answer be told by its name.
 *
 * @param name lower-case words with hyphens, unique in its topic
 * @param forms implementations of the mistake, one for each way in which it is made, such as for
 *     each of three sides
 * @param <C> the contract
 */
public record Slip<C>(String name, List<C> forms) {
    public Slip {
        forms = List.copyOf(forms);
        if (forms.isEmpty()) throw new IllegalArgumentException("slip " + name + " has no form");
    }

    /** A mistake that is made in one way. */
    public static <C> Slip<C> of(String name, C only) {
        return new Slip<>(name, List.of(only));
    }

    /** A mistake that is made in one of two ways. */
    public static <C> Slip<C> of(String name, C one, C other) {
        return new Slip<>(name, List.of(one, other));
    }

    /** A mistake that is made in one of three ways. */
    public static <C> Slip<C> of(String name, C first, C second, C third) {
        return new Slip<>(name, List.of(first, second, third));
    }

    /** A mistake that is made in one of four ways. */
    public static <C> Slip<C> of(String name, C first, C second, C third, C fourth) {
        return new Slip<>(name, List.of(first, second, third, fourth));
    }
}
