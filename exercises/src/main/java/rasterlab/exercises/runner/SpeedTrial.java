package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.runner.child.SummingPixels;
import rasterlab.exercises.score.Message;

/**
 * The student's cost per pixel against that of the reference method, each in a child of its own, in
 * turns on the same inputs; the clock is this process's.
 */
final class SpeedTrial {
    private static final int LEAST_ROUNDS = 8;

    /** As long as the method looks slower than this, the machine may be to blame: try on. */
    private static final double GOOD_RATIO = 1.4;

    /** For all rounds together, so that a slow method is not waited for. */
    private static final long BUDGET_NANOS = 1_500_000_000L;

    private static final int SEGMENTS = 250;

    /** Odd, so that no step is a tie and every right method sums up to the same. */
    private static final int STEPS = 1001;

    private final StudentRun student;
    private final StudentRun reference;
    private final Random random;

    /**
     * @param seed not known to the student, so that nothing can be computed beforehand
     */
    SpeedTrial(StudentRun student, StudentRun reference, long seed) {
        this.student = student;
        this.reference = reference;
        this.random = new Random(seed);
    }

    /**
     * The outcome.
     *
     * @param nanosPerPixel of the student's method; 0 where it was not measured
     * @param ratio to the reference; 0 where it was not measured
     * @param printed whether the method printed, which takes time
     * @param obstacle why it was not measured; nothing where it was
     */
    record Outcome(double nanosPerPixel, double ratio, boolean printed, Message obstacle) {
        static Outcome none(Message obstacle) {
            return new Outcome(0, 0, false, obstacle);
        }
    }

    Outcome measure() throws ChildLost, InterruptedException {
        loadReference();
        double theirs = Double.MAX_VALUE;
        double ours = Double.MAX_VALUE;
        boolean printed = false;
        long start = System.nanoTime();
        for (int round = 1; round <= LEAST_ROUNDS || theirs > GOOD_RATIO * ours; round++) {
            List<Segment> segments = segments();
            SummingPixels right = drawnHere(segments);
            StudentRun.Timed reply = student.time(segments);
            if (!reply.thrown().isEmpty())
                return Outcome.none(Message.of("speed.threw", reply.thrown()));
            if (reply.count() != right.count() || reply.sum() != right.sum())
                return Outcome.none(Message.of("speed.wrong"));
            printed |= reply.printed() > 0;
            // the quickest round counts: what else the machine does only ever adds time
            theirs = Math.min(theirs, (double) reply.nanos() / right.count());
            long reference = this.reference.time(segments).nanos();
            ours = Math.min(ours, (double) reference / right.count());
            if (System.nanoTime() - start > BUDGET_NANOS) break;
        }
        return new Outcome(theirs, theirs / ours, printed, Message.NONE);
    }

    private static SummingPixels drawnHere(List<Segment> segments) {
        SummingPixels right = new SummingPixels();
        BresenhamLine method = new BresenhamLine();
        for (Segment one : segments) method.draw(one.x0(), one.y0(), one.x1(), one.y1(), right);
        return right;
    }

    /** Draws once first: the student's method, too, has met another sink before it is timed. */
    private void loadReference() throws ChildLost, InterruptedException {
        Map<String, byte[]> classes = new LinkedHashMap<>();
        ClassFiles.closure(BresenhamLine.class, "rasterlab/engine/line/")
                .forEach(
                        (resource, bytes) ->
                                classes.put(
                                        resource.replace(".class", "").replace('/', '.'), bytes));
        reference.load(BresenhamLine.class.getName(), classes);
        reference.draw(new Segment(0, 0, STEPS, STEPS / 2), 2 * STEPS);
    }

    private List<Segment> segments() {
        List<Segment> segments = new ArrayList<>();
        for (int i = 0; i < SEGMENTS; i++) {
            int x = random.nextInt(1000);
            int y = random.nextInt(1000);
            int across = random.nextInt(2 * STEPS + 1) - STEPS;
            int along = random.nextBoolean() ? STEPS : -STEPS;
            segments.add(
                    random.nextBoolean()
                            ? new Segment(x, y, x + along, y + across)
                            : new Segment(x, y, x + across, y + along));
        }
        return segments;
    }
}
