package rasterlab.engine.study;

/**
 * How far an output is from the exact one.
 *
 * @param worst the largest error, in the topic's {@link Topic#errorUnit unit}; 0 where the items
 *     themselves are right, though perhaps repeated or out of order
 * @param missing exact items that were not produced
 * @param extra produced items that are not exact
 * @param of number of exact items
 * @param first the first difference for people, such as "pixel (1, 2) is missing"; empty when exact
 */
public record Deviation(double worst, long missing, long extra, long of, String first) {
    public static final Deviation NONE = new Deviation(0, 0, 0, 0, "");

    public boolean exact() {
        return worst == 0 && missing == 0 && extra == 0 && first.isEmpty();
    }
}
