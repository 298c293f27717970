package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import rasterlab.engine.line.BresenhamLine;
import rasterlab.engine.line.Segment;
import rasterlab.exercises.runner.child.SummingPixels;

/**
 * The student's cost per pixel against that of the reference method, each in a child of its own, in
 * turns on the same inputs; the clock is this process's.
 */
final class SpeedTrial {
    private static final int ROUNDS = 10;
    private static final int COUNTED = 6;
    private static final int SEGMENTS = 250;

    /** Odd, so that no step is a tie and every right method sums up to the same. */
    private static final int STEPS = 1001;

    /** A round that takes longer is enough to tell; no more are run. */
    private static final long SLOW_NANOS = 300_000_000;

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
     * @param nanosPerPixel of the student's method; 0 where it drew something wrong
     * @param ratio to the reference; 0 where it drew something wrong
     */
    record Outcome(double nanosPerPixel, double ratio) {
        static final Outcome WRONG = new Outcome(0, 0);
    }

    Outcome measure() throws ChildLost, InterruptedException {
        loadReference();
        List<Double> ours = new ArrayList<>();
        List<Double> theirs = new ArrayList<>();
        for (int round = 0; round < ROUNDS; round++) {
            List<Segment> segments = segments();
            SummingPixels right = new SummingPixels();
            BresenhamLine method = new BresenhamLine();
            for (Segment one : segments) method.draw(one.x0(), one.y0(), one.x1(), one.y1(), right);
            StudentRun.Timed reply = student.time(segments);
            if (reply.count() != right.count() || reply.sum() != right.sum()) return Outcome.WRONG;
            theirs.add((double) reply.nanos() / right.count());
            ours.add((double) reference.time(segments).nanos() / right.count());
            if (reply.nanos() > SLOW_NANOS) break;
        }
        double nanos = best(theirs);
        return new Outcome(nanos, nanos / best(ours));
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

    /** The quickest of the last rounds: what else the machine does only ever adds time. */
    private static double best(List<Double> rounds) {
        return rounds.stream()
                .skip(Math.max(0, rounds.size() - COUNTED))
                .mapToDouble(Double::doubleValue)
                .min()
                .orElseThrow();
    }
}
