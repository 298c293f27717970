package rasterlab.exercises.formula;

/**
 * A formula as its author wrote it.
 *
 * @param tex what stands between the dollars
 * @param displayed whether it stands on lines of its own, with room for large signs
 */
public record TexFormula(String tex, boolean displayed) {
    /** The formula with its dollars, as in the statement. */
    public String source() {
        String dollars = displayed ? "$$" : "$";
        return dollars + tex + dollars;
    }
}
