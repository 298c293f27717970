package rasterlab.exercises.runner;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.score.Message;

/**
 * The student's cost per pixel against that of the reference method, each in a child of its own, in
 * turns on the same inputs.
 */
final class SpeedTrial {
    private static final int LEAST_ROUNDS = 12;

    /** For all rounds together, so that a slow method is not waited for. */
    private static final long BUDGET_NANOS = 1_500_000_000L;

    private final TopicGrading topic;
    private final StudentRun student;
    private final StudentRun reference;
    private final Set<String> charged;
    private final Random random;

    /**
     * @param charged codes of mistakes that cost points already, and cost none here
     * @param seed not known to the student, so that nothing can be computed beforehand
     */
    SpeedTrial(
            TopicGrading topic,
            StudentRun student,
            StudentRun reference,
            Set<String> charged,
            long seed) {
        this.topic = topic;
        this.student = student;
        this.reference = reference;
        this.charged = charged;
        this.random = new Random(seed);
    }

    /**
     * The outcome.
     *
     * @param nanosPerPixel of the student's method; 0 where it was not measured
     * @param reference the same of the reference
     * @param printed whether the method printed, which takes time
     * @param obstacle why it was not measured; nothing where it was
     */
    record Outcome(double nanosPerPixel, double reference, boolean printed, Message obstacle) {
        static Outcome none(Message obstacle) {
            return new Outcome(0, 0, false, obstacle);
        }
    }

    Outcome measure() throws ChildLost, InterruptedException {
        loadReference();
        Pace theirs = new Pace();
        Pace ours = new Pace();
        boolean printed = false;
        long start = System.nanoTime();
        for (int round = 1; round <= LEAST_ROUNDS || !theirs.isSettledBeside(ours); round++) {
            TopicGrading.Timing timing = topic.timing(random);
            StudentRun.Timed reply = student.time(timing);
            if (!reply.thrown().isEmpty())
                return Outcome.none(Message.of("speed.threw", reply.thrown()));
            if (!timing.mistakes(reply.count(), reply.sum())
                    .filter(charged::containsAll)
                    .isPresent()) return Outcome.none(Message.of("speed.wrong"));
            printed |= reply.printed() > 0;
            theirs.add(reply, timing.count());
            ours.add(reference.time(timing), timing.count());
            if (System.nanoTime() - start > BUDGET_NANOS) break;
        }
        return theirs.isCredibleBeside(ours)
                ? new Outcome(theirs.own(), ours.own(), printed, Message.NONE)
                : new Outcome(theirs.wall(), ours.wall(), printed, Message.NONE);
    }

    /** Draws once first: the student's method, too, has met another sink before it is timed. */
    private void loadReference() throws ChildLost, InterruptedException {
        Class<?> method = topic.reference();
        String own = method.getPackageName().replace('.', '/') + '/';
        Map<String, byte[]> classes = new LinkedHashMap<>();
        ClassFiles.closure(method, own)
                .forEach(
                        (resource, bytes) ->
                                classes.put(
                                        resource.replace(".class", "").replace('/', '.'), bytes));
        reference.load(method.getName(), classes);
        reference.call(topic.warmUp());
    }
}
