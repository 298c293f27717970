package rasterlab.exercises.line;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.child.SummingPixels;
import rasterlab.exercises.child.Wire;

/** Long segments in all directions, and what they sum up to. */
final class LineTiming implements TopicGrading.Timing {
    /** Odd, so that no step is a tie and every right method sums up to the same. */
    static final int STEPS = 1001;

    private static final int SEGMENTS = 250;

    private final List<Segment> segments = new ArrayList<>();
    private final SummingPixels right = new SummingPixels();

    LineTiming(Random random) {
        for (int i = 0; i < SEGMENTS; i++) segments.add(segment(random));
        BresenhamLine method = new BresenhamLine();
        for (Segment one : segments) method.draw(one.x0(), one.y0(), one.x1(), one.y1(), right);
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
        for (Segment segment : segments) LineGrading.write(out, segment);
    }

    @Override
    public long count() {
        return right.count();
    }

    @Override
    public long sum() {
        return right.sum();
    }
}
