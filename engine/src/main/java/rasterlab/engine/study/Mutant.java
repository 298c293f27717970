package rasterlab.engine.study;

import java.util.regex.Pattern;

/**
 * A named mistake that learners make, as an implementation that is right but for it.
 *
 * @param name lower-case words with hyphens, at most 40 characters, unique in its topic
 * @param hazard name of the hazard that is there for this mistake and catches it
 * @param implementation the contract with that one mistake
 * @param <C> the contract
 */
public record Mutant<C>(String name, String hazard, C implementation) {
    private static final Pattern NAME = Pattern.compile("[a-z0-9]+(-[a-z0-9]+)*");
    private static final int LONGEST = 40;

    public Mutant {
        if (!NAME.matcher(name).matches() || name.length() > LONGEST)
            throw new IllegalArgumentException(
                    "mutant name must be lower-case words with hyphens, at most "
                            + LONGEST
                            + " characters, got '"
                            + name
                            + "'");
    }

    @Override
    public String toString() {
        return name + " (" + hazard + ")";
    }
}
