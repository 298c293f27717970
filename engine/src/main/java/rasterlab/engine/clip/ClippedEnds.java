package rasterlab.engine.clip;

import java.util.List;
import java.util.Optional;

/**
 * The rest of each segment, in their order.
 *
 * @param parts the coordinates of the first end, then of the second; empty where nothing is left
 * @param again how many parts were sent beyond the one each segment may have
 */
public record ClippedEnds(List<Optional<double[]>> parts, int again) {
    public ClippedEnds {
        parts = List.copyOf(parts);
    }

    /** How many segments something is left of. */
    public long kept() {
        return parts.stream().filter(Optional::isPresent).count();
    }
}
