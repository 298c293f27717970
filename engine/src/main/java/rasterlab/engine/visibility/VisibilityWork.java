package rasterlab.engine.visibility;

import java.util.Map;
import java.util.TreeMap;

/**
 * The work of a method for one picture, counted and so free of noise.
 *
 * @param comparisons of a face with another face, or with a window or box that may hold some of it
 * @param depthTests depths of a face computed at a pixel, a window's corner or along a ray
 * @param pixelsWritten pixels coloured, each as often as it was
 * @param splits faces, spans or windows that were divided
 */
public record VisibilityWork(long comparisons, long depthTests, long pixelsWritten, long splits) {
    public static final VisibilityWork NONE = new VisibilityWork(0, 0, 0, 0);

    /** All of it in one number: each comparison, depth test and written pixel is one. */
    public long total() {
        return comparisons + depthTests + pixelsWritten;
    }

    public VisibilityWork plus(VisibilityWork other) {
        return new VisibilityWork(
                comparisons + other.comparisons,
                depthTests + other.depthTests,
                pixelsWritten + other.pixelsWritten,
                splits + other.splits);
    }

    /** Name in the plural to number. */
    public Map<String, Long> operations() {
        return new TreeMap<>(
                Map.of(
                        "comparisons", comparisons,
                        "depth tests", depthTests,
                        "pixels written", pixelsWritten,
                        "splits", splits));
    }
}
