package rasterlab.exercises.line;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import rasterlab.contract.Pixels;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.child.PixelSum;
import rasterlab.exercises.child.Wire;

/** Long segments in all directions, and what they sum up to. */
final class LineTiming implements TopicGrading.Timing {
    /** Odd, so that no step is a tie and every right method sums up to the same. */
    static final int STEPS = 1001;

    private static final int SEGMENTS = 250;
    private static final List<Variation> VARIATIONS = variations();

    private final List<Segment> segments = new ArrayList<>();
    private final PixelSum right = new PixelSum();

    LineTiming(Random random) {
        for (int i = 0; i < SEGMENTS; i++) segments.add(segment(random));
        for (Segment one : segments) draw(one, right);
    }

    private static void draw(Segment one, Pixels out) {
        new BresenhamLine().draw(one.x0(), one.y0(), one.x1(), one.y1(), out);
    }

    private static Segment segment(Random random) {
        int x = random.nextInt(1000);
        int y = random.nextInt(1000);
        int across = random.nextInt(2 * STEPS + 1) - STEPS;
        int along = random.nextBoolean() ? STEPS : -STEPS;
        return random.nextBoolean()
                ? new Segment(x, y, x + along, y + across)
                : new Segment(x, y, x + across, y + along);
    }

    @Override
    public int operation() {
        return Wire.TIME_LINES;
    }

    @Override
    public void writeTo(DataOutputStream out) throws IOException {
        out.writeInt(segments.size());
        out.writeInt((int) new LineTopic().mostBeforeEndless(STEPS + 1));
        out.writeInt(STEPS + 1);
        for (Segment segment : segments) LineGrading.write(out, segment);
    }

    @Override
    public long count() {
        return right.count();
    }

    @Override
    public Optional<Set<String>> mistakes(long count, long sum) {
        if (count == right.count() && sum == right.sum()) return Optional.of(Set.of());
        return VARIATIONS.stream()
                .filter(one -> isDrawn(one, count, sum))
                .map(Variation::codes)
                .findFirst();
    }

    private boolean isDrawn(Variation variation, long count, long sum) {
        PixelSum drawn = new PixelSum();
        for (Segment one : segments) draw(one, (x, y) -> variation.way().plot(one, x, y, drawn));
        return drawn.count() == count && drawn.sum() == sum;
    }

    /** A line with a mistake, by the pixels of the right one. */
    private record Variation(Set<String> codes, Way way) {}

    /** Plots what comes of one right pixel. */
    private interface Way {
        void plot(Segment s, int x, int y, Pixels out);
    }

    private static List<Variation> variations() {
        List<Variation> all = new ArrayList<>();
        Way withoutLast = (s, x, y, out) -> plotUnless(x == s.x1() && y == s.y1(), x, y, out);
        Way withoutFirst = (s, x, y, out) -> plotUnless(x == s.x0() && y == s.y0(), x, y, out);
        all.add(new Variation(Set.of("last-pixel"), withoutLast));
        all.add(new Variation(Set.of("first-pixel"), withoutFirst));
        all.add(
                new Variation(
                        Set.of("first-pixel", "last-pixel"),
                        (s, x, y, out) ->
                                withoutLast.plot(
                                        s, x, y, (a, b) -> withoutFirst.plot(s, a, b, out))));
        all.add(moved("mirrored-left-right", (s, x, y, out) -> out.plot(2 * s.x0() - x, y)));
        all.add(moved("mirrored-up-down", (s, x, y, out) -> out.plot(x, 2 * s.y0() - y)));
        all.add(moved("mirrored-left-right", (s, x, y, out) -> out.plot(-x, y)));
        all.add(moved("mirrored-up-down", (s, x, y, out) -> out.plot(x, -y)));
        all.add(moved("swapped-axes", (s, x, y, out) -> out.plot(y, x)));
        all.add(
                moved(
                        "swapped-axes",
                        (s, x, y, out) -> out.plot(s.x0() + y - s.y0(), s.y0() + x - s.x0())));
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++) {
                int right = dx;
                int down = dy;
                all.add(moved("shifted", (s, x, y, out) -> out.plot(x + right, y + down)));
            }
        return List.copyOf(all);
    }

    private static Variation moved(String code, Way way) {
        return new Variation(Set.of(code), way);
    }

    private static void plotUnless(boolean leftOut, int x, int y, Pixels out) {
        if (!leftOut) out.plot(x, y);
    }
}
