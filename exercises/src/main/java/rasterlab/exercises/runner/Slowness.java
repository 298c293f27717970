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

    private static final long WARM_UP_NANOS = BUDGET_NANOS / 6;

    private final TopicGrading topic;
    private final Student program;
    private final Student reference;

    Slowness(TopicGrading topic, Student program, Student reference) {
        this.topic = topic;
        this.program = program;
        this.reference = reference;
    }

    /**
     * The median of the paces' ratio; empty where a call threw, or the clocks cannot be believed.
     */
    OptionalDouble measure(List<?> inputs) throws ChildLost, InterruptedException {
        var pace = new Pace();
        TimedBatch batch;
        try {
            TopicGrading.TimingInputs timing = topic.timing(inputs);
            batch =
                    new TimedBatch(
                            ContractCalls.of(topic.contract()), timing, Exercise.StatedLimits.NONE);
        } catch (LimitReached | IllegalArgumentException untimed) {
            return OptionalDouble.empty();
        }
        var warmUp = new Pace.WarmUp(WARM_UP_NANOS);
        long start = System.nanoTime();
        for (int round = 0; round < MOST_ROUNDS; round++) {
            StudentRun.Timed reply = program.run().time(batch);
            boolean answered = reply.thrown().isEmpty() && !reply.tooLong();
            // as a study measures methods, for each item that is made, right or wrong
            if (!answered || reply.answers().count() == 0) return OptionalDouble.empty();
            StudentRun.Timed right = reference.run().time(batch);
            long elapsed = System.nanoTime() - start;
            if (warmUp.isOver(reply, right, reply.answers().count(), elapsed))
                pace.add(
                        reply,
                        reply.answers().count(),
                        right,
                        Math.max(1, right.answers().count()));
            if (elapsed > BUDGET_NANOS) break;
        }
        return pace.pairs() > 0 && pace.isTimed()
                ? OptionalDouble.of(pace.ratio().median())
                : OptionalDouble.empty();
    }
}
