package rasterlab.engine.study;

/**
 * An implementation of a contract with one mistake, which a hazard must catch.
 *
 * @param mistake what it does wrong, in a few words
 * @param hazard name of the hazard that is there for this mistake
 * @param implementation right but for the mistake
 */
public record Mutant<C>(String mistake, String hazard, C implementation) {
    @Override
    public String toString() {
        return mistake + " (" + hazard + ")";
    }
}
