package rasterlab.engine.raster;

import java.util.Map;

/**
 * Arithmetic that a method does to choose its pixels; steps of the coordinates and of the loop,
 * which all methods share, are left out.
 *
 * @param additions and subtractions; doubling is one
 * @param roundings to whole numbers
 * @param comparisons by which the method decides
 */
public record Work(
        int additions, int multiplications, int divisions, int roundings, int comparisons) {
    /** No arithmetic. */
    public static final Work NONE = new Work(0, 0, 0, 0, 0);

    /** Adds this work, done so many times, to the counts. */
    public void addTo(Map<String, Long> counts, long times) {
        counts.merge("additions", times * additions, Long::sum);
        counts.merge("multiplications", times * multiplications, Long::sum);
        counts.merge("divisions", times * divisions, Long::sum);
        counts.merge("roundings", times * roundings, Long::sum);
        counts.merge("comparisons", times * comparisons, Long::sum);
    }
}
