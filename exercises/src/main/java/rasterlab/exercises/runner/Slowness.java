package rasterlab.exercises.runner;

import java.util.List;
import java.util.OptionalDouble;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.runner.process.ChildLost;

/** Times a program and the reference in turns on the same inputs, whatever the program answers. */
final class Slowness {
    private static final int MOST_ROUNDS = 40;

    /** Wall time for all rounds, so that a slow method is not waited for. */
    private static final long BUDGET_NANOS = 1_500_000_000L;

    private final TopicGrading topic;
    private final Student program;
    private final Student reference;

    Slowness(TopicGrading topic, Student program, Student reference) {
        this.topic = topic;
        this.program = program;
        this.reference = reference;
    }

    /** The ratio of both paces; empty where a call threw, or the clocks cannot be believed. */
    OptionalDouble measure(List<?> inputs) throws ChildLost, InterruptedException {
        var theirs = new Pace();
        var ours = new Pace();
        TimedBatch batch;
        try {
            TopicGrading.Timing timing = topic.timing(inputs);
            batch = new TimedBatch(ContractCalls.of(topic.contract()), timing, Exercise.Caps.NONE);
        } catch (LimitReached | IllegalArgumentException untimed) {
            return OptionalDouble.empty();
        }
        long start = System.nanoTime();
        for (int round = 0; round < MOST_ROUNDS; round++) {
            StudentRun.Timed reply = program.run().time(batch);
            boolean answered = reply.thrown().isEmpty() && !reply.tooLong();
            // as a study measures methods, for each item that is made, right or wrong
            if (!answered || reply.told().count() == 0) return OptionalDouble.empty();
            theirs.add(reply, reply.told().count());
            StudentRun.Timed right = reference.run().time(batch);
            ours.add(right, Math.max(1, right.told().count()));
            if (System.nanoTime() - start > BUDGET_NANOS) break;
        }
        return theirs.own() > 0 && ours.own() > 0
                ? OptionalDouble.of(theirs.own() / ours.own())
                : OptionalDouble.empty();
    }
}
