package rasterlab.exercises.line;

import java.util.Collection;
import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.TopicGrading;

/** Draws long segments to time a method on, in the octants that are worth it. */
final class LineTimings implements TopicGrading.Timings {
    private final Random random;
    private final Set<Integer> leftOut;
    private final LineVariation.Likely likely = new LineVariation.Likely();

    /**
     * @param wrongOn traits of lines that were wrong for no known reason: their octants are left
     *     out, unless more than half of all would be
     */
    LineTimings(Random random, Collection<Set<String>> wrongOn) {
        this.random = random;
        Set<Integer> wrong = new HashSet<>();
        for (Set<String> traits : wrongOn) if (hasOctant(traits)) wrong.add(octant(traits));
        this.leftOut = 2 * wrong.size() <= OctantSums.OCTANTS ? wrong : Set.of();
    }

    /** A line far away may be wrong for its numbers alone. */
    private static boolean hasOctant(Set<String> traits) {
        return (traits.contains("steep") || traits.contains("gentle")) && !traits.contains("far");
    }

    private static int octant(Set<String> traits) {
        int along = traits.contains("left") ? -1 : 1;
        int down = traits.contains("up") ? -1 : 1;
        return OctantSums.octant(
                traits.contains("steep")
                        ? new Segment(0, 0, along, 2 * down)
                        : new Segment(0, 0, 2 * along, down));
    }

    @Override
    public TopicGrading.Timing next() {
        return new LineTiming(this::segment, likely);
    }

    private Segment segment() {
        Segment segment = anySegment();
        while (leftOut.contains(OctantSums.octant(segment))) segment = anySegment();
        return segment;
    }

    /** Neither horizontal, vertical nor at 45°: all of it lies in one octant. */
    private Segment anySegment() {
        int x = random.nextInt(1000);
        int y = random.nextInt(1000);
        int most = LineTiming.STEPS - 1;
        int across = (1 + random.nextInt(most)) * (random.nextBoolean() ? 1 : -1);
        int along = random.nextBoolean() ? LineTiming.STEPS : -LineTiming.STEPS;
        return random.nextBoolean()
                ? new Segment(x, y, x + along, y + across)
                : new Segment(x, y, x + across, y + along);
    }
}
