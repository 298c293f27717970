package rasterlab.exercises.runner;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.UnaryOperator;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.engine.study.measuring.RoundPlan;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.SpeedPoints;

/**
 * The student's cost per pixel against that of the reference method, each in a child of its own, in
 * turns on the same inputs. Both children have drawn the same before, so that Java compiled both
 * methods for the same calls.
 */
final class SpeedTrial {
    /** Rounds that count in any case: of fewer the interval promises less. */
    private static final int LEAST_ROUNDS = RoundPlan.LEAST;

    /** Wall time for all rounds of one try, so that a slow method is not waited for. */
    private static final long BUDGET_NANOS = 3_000_000_000L;

    /** Wall time after which rounds count although they still become faster. */
    private static final long WARM_UP_NANOS = BUDGET_NANOS / 6;

    /**
     * The number of calls that show Java how a method is used; a slow one is not waited for longer.
     */
    private static final int MOST_BEFORE = 60;

    /** The most tries, each in fresh children, later than the one before. */
    private static final int MOST_TRIES = 4;

    private final ContractCalls contract;
    private final Exercise.StatedLimits caps;
    private final TopicGrading.Timings timings;
    private final UnaryOperator<String> words;
    private final Student student;
    private final Student reference;
    private final List<GradedCall> before;
    private final Set<String> charged;
    private final Patience patience;
    private final Pace pace = new Pace();
    private boolean begun;
    private boolean printed;
    private Optional<TopicGrading.TimingInputs> last = Optional.empty();

    /**
     * @param caps limits of a call that the exercise states
     * @param before what both draw before they are timed
     * @param timings what they are timed on, not known to the student, so that nothing can be
     *     computed beforehand
     * @param words the key of a text in the topic's words
     * @param begun whether fresh children of both have just drawn the same
     * @param charged codes of mistakes that cost points already, and cost none here
     * @param patience tells whether the machine is busy
     */
    SpeedTrial(
            ContractCalls contract,
            Exercise.StatedLimits caps,
            TopicGrading.Timings timings,
            UnaryOperator<String> words,
            Student student,
            Student reference,
            List<GradedCall> before,
            boolean begun,
            Set<String> charged,
            Patience patience) {
        this.contract = contract;
        this.caps = caps;
        this.timings = timings;
        this.words = words;
        this.student = student;
        this.reference = reference;
        this.before = List.copyOf(before.subList(0, Math.min(MOST_BEFORE, before.size())));
        this.begun = begun;
        this.charged = charged;
        this.patience = patience;
    }

    /**
     * The outcome.
     *
     * @param ratio of the student's time to the reference's; empty where nothing is known
     * @param reference nanoseconds per pixel of the reference
     * @param printed whether the method printed, which takes time
     * @param obstacle why it was not measured; nothing where it was
     */
    record SpeedOutcome(
            Optional<MedianInterval> ratio, double reference, boolean printed, Message obstacle) {
        static SpeedOutcome none(Message obstacle) {
            return new SpeedOutcome(Optional.empty(), 0, false, obstacle);
        }

        boolean isKnown() {
            return ratio.isPresent();
        }

        /** Nanoseconds per pixel of the student's method; 0 where nothing is known. */
        double nanosPerPixel() {
            return ratio.map(one -> one.median() * reference).orElse(0.0);
        }

        /** The least that the ratio can be: only what is slower for certain costs points. */
        double leastRatio() {
            return ratio.orElseThrow().low();
        }

        /** Whether it would have been measured, had the machine been calm enough. */
        boolean unsettled() {
            return obstacle.equals(UNSETTLED);
        }
    }

    /** The machine did not let it be measured. */
    static final Message UNSETTLED = Message.of("speed.unsettled");

    /**
     * Measures until the interval of the ratio tells the points and the child's clock can be
     * believed. A busy machine may allow neither.
     */
    SpeedOutcome measure() throws ChildLost, InterruptedException {
        for (int left = MOST_TRIES; left > 0; left--) {
            Optional<Message> obstacle = tried();
            if (obstacle.isPresent()) return SpeedOutcome.none(obstacle.get());
            if (pace.isSettled() && isCertain(pace.ratio())) break;
        }
        if (pace.pairs() == 0) return SpeedOutcome.none(UNSETTLED);
        if (pace.isSettled() || pace.isRoughlyTold()) return outcome(Message.NONE);
        return patience.isBusy() || pace.isCredible()
                ? outcome(UNSETTLED)
                : new SpeedOutcome(
                        Optional.of(pace.wallRatio()), pace.wallReference(), printed, Message.NONE);
    }

    /**
     * Whether a further try would hardly change the points: it costs none already, or is far from
     * where it would cost others.
     */
    private static boolean isCertain(MedianInterval ratio) {
        return SpeedPoints.band(ratio.low(), OptionalInt.empty()) == 0
                || !SpeedPoints.isNearAnEnd(ratio.median());
    }

    /** The message of one batch: why nothing could be measured, or no more than that it could. */
    SpeedOutcome once() throws ChildLost, InterruptedException {
        TopicGrading.TimingInputs timing = timings.next();
        StudentRun.Timed reply = student.run().time(new TimedBatch(contract, timing, caps));
        return SpeedOutcome.none(obstacle(timing, reply).orElse(UNSETTLED));
    }

    /** The last inputs that both were timed on; empty before there were any. */
    Optional<TopicGrading.TimingInputs> last() {
        return last;
    }

    private SpeedOutcome outcome(Message obstacle) {
        return new SpeedOutcome(Optional.of(pace.ratio()), pace.reference(), printed, obstacle);
    }

    /** Why nothing can be measured; empty where something was. */
    private Optional<Message> tried() throws ChildLost, InterruptedException {
        if (!begun) beginBoth();
        begun = false;
        var warmUp = new Pace.WarmUp(WARM_UP_NANOS);
        long start = System.nanoTime();
        int counted = 0;
        while (counted < LEAST_ROUNDS || !pace.isSettled()) {
            TopicGrading.TimingInputs timing = timings.next();
            last = Optional.of(timing);
            TimedBatch batch = new TimedBatch(contract, timing, caps);
            StudentRun.Timed reply = student.run().time(batch);
            Optional<Message> obstacle = obstacle(timing, reply);
            if (obstacle.isPresent()) return obstacle;
            if (batch.mayHideALongCall(reply.nanos())) holdEach(batch, timing.inputs());
            printed |= reply.printed() > 0;
            Optional<StudentRun.Timed> ours = timedReference(batch);
            if (ours.isEmpty()) return Optional.empty();
            long elapsed = System.nanoTime() - start;
            if (warmUp.isOver(reply, ours.get(), timing.count(), elapsed)) {
                pace.add(reply, timing.count(), ours.get(), timing.count());
                counted++;
            }
            if (elapsed > BUDGET_NANOS) break;
        }
        return Optional.empty();
    }

    /** Both draw the same in fresh children. */
    private void beginBoth() throws ChildLost, InterruptedException {
        try (var beside = new CallsBeside(reference, before)) {
            CallsBeside.make(student, before);
            beside.await();
        }
    }

    /** Has each input answered alone, within the time that the exercise states for it. */
    private void holdEach(TimedBatch batch, int inputs) throws ChildLost, InterruptedException {
        for (int i = 0; i < inputs; i++) student.run().time(batch.alone(i));
    }

    /**
     * Times the reference; empty where it was lost, which no student can help: then nothing is
     * settled.
     */
    private Optional<StudentRun.Timed> timedReference(TimedBatch batch)
            throws InterruptedException {
        try {
            return Optional.of(reference.run().time(batch));
        } catch (ChildLost lost) {
            reference.close();
            return Optional.empty();
        }
    }

    /** An exception of the student's own is not named: its name may tell what it was thrown for. */
    private Optional<Message> obstacle(TopicGrading.TimingInputs timing, StudentRun.Timed reply) {
        if (!reply.thrown().isEmpty())
            return Optional.of(
                    Answer.isOfTheJdk(reply.thrown())
                            ? Message.of(words.apply("speed.threw"), reply.thrown())
                            : Message.of(words.apply("speed.threw-own")));
        if (reply.tooLong()) return Optional.of(Message.of("speed.too-long"));
        boolean right = timing.mistakes(reply.answers()).filter(charged::containsAll).isPresent();
        return right ? Optional.empty() : Optional.of(Message.of(words.apply("speed.wrong")));
    }
}
