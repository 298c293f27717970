package rasterlab.exercises.line;

import java.util.List;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;

/**
 * One case on drawing a segment. The pixels must come once each, from the first end to the second.
 *
 * @param segments to draw one after the other; the case is right when all are
 * @param strictTies whether a tie must go to the smaller coordinate even where the exercise
 *     tolerates either pixel
 * @param firstPixels the most pixels of a segment to look at; the method is stopped there
 * @param mayRefuse whether an IllegalArgumentException is as good as the pixels
 */
public record LineCase(
        List<Segment> segments, boolean strictTies, int firstPixels, boolean mayRefuse) {
    /** What {@code firstPixels} may be at most, and is where a case does not say. */
    public static final int MOST_PIXELS = 20_000;

    public LineCase {
        segments = List.copyOf(segments);
        if (segments.isEmpty())
            throw new IllegalArgumentException("a line case needs at least one segment");
        if (firstPixels < 1 || firstPixels > MOST_PIXELS)
            throw new IllegalArgumentException(
                    "firstPixels must be from 1 to " + MOST_PIXELS + ", got " + firstPixels);
    }

    /** Whether only the beginning of that segment is looked at. */
    boolean cutShort(Segment segment) {
        return segment.steps() >= firstPixels;
    }

    /** The most pixels that a method may plot for that segment. */
    public int mostPixels(Segment segment) {
        return cutShort(segment)
                ? firstPixels
                : (int) new LineTopic().mostBeforeEndless(segment.steps() + 1);
    }
}
