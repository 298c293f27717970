package rasterlab.engine.pipeline.direct;

/**
 * The work that a plan has proved a picture can do without.
 *
 * @param levels by how many levels of 0 to 255 light that is mixed from a face's corners may differ
 *     from the formula at each pixel; 0 works it out at each pixel everywhere
 * @param frontsOnly whether faces that show their back are left out, because others hide them
 */
public record Savings(double levels, boolean frontsOnly) {
    /** Nothing is left out. */
    public static final Savings NONE = new Savings(0, false);

    public Savings {
        if (!(levels >= 0 && levels < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "levels must be finite and at least 0, got " + levels);
    }
}
