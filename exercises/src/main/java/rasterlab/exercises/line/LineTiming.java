package rasterlab.exercises.line;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Supplier;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.TopicGrading;

/**
 * Long segments in many directions, and what they sum up to.
 *
 * <p>The rule by which a method is timed although it has a mistake: in each octant the lines must
 * be right, or all be wrong in one way that is known ({@link LineVariation}) and that lost its
 * points in a case already; whoever draws every pixel twice is timed with that work. No line lies
 * in an octant where a case was wrong for a reason that is not known, as long as half of the
 * octants are left. What is wrong otherwise is not timed, and neither is a table, a constant or
 * nothing, which do not get so far: the accuracy asked for first is out of their reach.
 */
final class LineTiming implements TopicGrading.Timing {
    /** Odd, so that no step is a tie and every right method sums up to the same. */
    static final int STEPS = 1001;

    private static final int SEGMENTS = 250;

    private final List<Segment> segments = new ArrayList<>();
    private final LineVariation.Likely likely;
    private final OctantSums right;

    /**
     * @param segment draws the next one
     * @param likely the variation that explained the lines before
     */
    LineTiming(Supplier<Segment> segment, LineVariation.Likely likely) {
        for (int i = 0; i < SEGMENTS; i++) segments.add(segment.get());
        this.likely = likely;
        this.right = OctantSums.of(segments, LineVariation.RIGHT);
    }

    @Override
    public int inputs() {
        return segments.size();
    }

    @Override
    public Object recorded(int input, Object method) {
        return new LineTopic().record((LineRasterizer) method, segments.get(input), mostItems());
    }

    @Override
    public int mostItems() {
        return (int) new LineTopic().mostBeforeEndless(STEPS + 1);
    }

    @Override
    public int usualItems() {
        return STEPS + 1;
    }

    /** None: the sums of all lines tell enough. */
    @Override
    public OptionalInt looked() {
        return OptionalInt.empty();
    }

    @Override
    public Object right() {
        return new PlainBresenham();
    }

    @Override
    public long count() {
        return right.count();
    }

    @Override
    public Optional<Set<String>> mistakes(TopicGrading.Told told) {
        long count = told.count();
        long sum = told.sum();
        if (count == right.count() && sum == right.sum()) return Optional.of(Set.of());
        return likely.first(one -> OctantSums.of(segments, one).mixedWith(right, count, sum))
                .map(LineVariation::codes);
    }
}
