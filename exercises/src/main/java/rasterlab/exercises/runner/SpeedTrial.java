package rasterlab.exercises.runner;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.Call;
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
    private static final int LEAST_ROUNDS = 12;

    /** Wall time for all rounds of one try, so that a slow method is not waited for. */
    private static final long BUDGET_NANOS = 3_000_000_000L;

    /**
     * The number of calls that show Java how a method is used; a slow one is not waited for longer.
     */
    private static final int MOST_BEFORE = 60;

    /** The most tries, each in fresh children, later than the one before. */
    private static final int MOST_TRIES = 4;

    private final ContractCalls contract;
    private final Exercise.Caps caps;
    private final TopicGrading.Timings timings;
    private final UnaryOperator<String> words;
    private final Student student;
    private final Student reference;
    private final List<Call> before;
    private final Set<String> charged;
    private final Patience patience;
    private final Pace theirs = new Pace();
    private final Pace ours = new Pace();
    private boolean printed;
    private Optional<TopicGrading.Timing> last = Optional.empty();

    /**
     * @param caps limits of a call that the exercise states
     * @param before what both draw before they are timed
     * @param timings what they are timed on, not known to the student, so that nothing can be
     *     computed beforehand
     * @param words the key of a text in the topic's words
     * @param charged codes of mistakes that cost points already, and cost none here
     * @param patience tells whether the machine is busy
     */
    SpeedTrial(
            ContractCalls contract,
            Exercise.Caps caps,
            TopicGrading.Timings timings,
            UnaryOperator<String> words,
            Student student,
            Student reference,
            List<Call> before,
            Set<String> charged,
            Patience patience) {
        this.contract = contract;
        this.caps = caps;
        this.timings = timings;
        this.words = words;
        this.student = student;
        this.reference = reference;
        this.before = List.copyOf(before.subList(0, Math.min(MOST_BEFORE, before.size())));
        this.charged = charged;
        this.patience = patience;
    }

    /**
     * The outcome.
     *
     * @param nanosPerPixel of the student's method; 0 where nothing is known
     * @param reference the same of the reference
     * @param printed whether the method printed, which takes time
     * @param obstacle why it was not measured; nothing where it was
     */
    record Outcome(double nanosPerPixel, double reference, boolean printed, Message obstacle) {
        static Outcome none(Message obstacle) {
            return new Outcome(0, 0, false, obstacle);
        }

        boolean isKnown() {
            return nanosPerPixel > 0;
        }

        double ratio() {
            return nanosPerPixel / reference;
        }

        /** Whether it would have been measured, had the machine been calm enough. */
        boolean unsettled() {
            return obstacle.equals(UNSETTLED);
        }
    }

    /** The machine did not let it be measured. */
    static final Message UNSETTLED = Message.of("speed.unsettled");

    /**
     * Measures until the reference repeats itself and the child's clock can be believed. A busy
     * machine may allow neither: then what the child tells is the least that it can have been.
     */
    Outcome measure() throws ChildLost, InterruptedException {
        for (int left = MOST_TRIES; left > 0; left--) {
            Optional<Message> obstacle = tried();
            if (obstacle.isPresent()) return Outcome.none(obstacle.get());
            if (isSettled() && !SpeedPoints.isNearAnEnd(told(Message.NONE).ratio())) break;
        }
        if (!ours.isMeasured()) return Outcome.none(UNSETTLED);
        if (isSettled()) return told(Message.NONE);
        return patience.isBusy() || theirs.isCredibleBeside(ours)
                ? told(UNSETTLED)
                : new Outcome(theirs.wall(), ours.wall(), printed, Message.NONE);
    }

    /** The message of one batch: why nothing could be measured, or no more than that it could. */
    Outcome once() throws ChildLost, InterruptedException {
        TopicGrading.Timing timing = timings.next();
        StudentRun.Timed reply = student.run().time(new TimedBatch(contract, timing, caps));
        return Outcome.none(obstacle(timing, reply).orElse(UNSETTLED));
    }

    /** The last inputs that both were timed on; empty before there were any. */
    Optional<TopicGrading.Timing> last() {
        return last;
    }

    private boolean isSettled() {
        return ours.isRepeated() && theirs.isCredibleBeside(ours);
    }

    private Outcome told(Message obstacle) {
        return new Outcome(theirs.own(), ours.own(), printed, obstacle);
    }

    /** Why nothing can be measured; empty where something was. */
    private Optional<Message> tried() throws ChildLost, InterruptedException {
        for (Student one : List.of(student, reference)) {
            one.beginAnew();
            for (Call call : before) one.call(call);
        }
        long start = System.nanoTime();
        for (int round = 1; round <= LEAST_ROUNDS || !theirs.isSettledBeside(ours); round++) {
            TopicGrading.Timing timing = timings.next();
            last = Optional.of(timing);
            TimedBatch batch = new TimedBatch(contract, timing, caps);
            StudentRun.Timed reply = student.run().time(batch);
            Optional<Message> obstacle = obstacle(timing, reply);
            if (obstacle.isPresent()) return obstacle;
            if (batch.mayHideALongCall(reply.nanos())) holdEach(batch, timing.inputs());
            printed |= reply.printed() > 0;
            theirs.add(reply, timing.count());
            if (!timeReference(batch, timing.count())) return Optional.empty();
            if (System.nanoTime() - start > BUDGET_NANOS) break;
        }
        return Optional.empty();
    }

    /** Has each input answered alone, within the time that the exercise states for it. */
    private void holdEach(TimedBatch batch, int inputs) throws ChildLost, InterruptedException {
        for (int i = 0; i < inputs; i++) student.run().time(batch.alone(i));
    }

    /**
     * Times the reference; false where it was lost, which no student can help: then nothing is
     * settled.
     */
    private boolean timeReference(TimedBatch batch, long count) throws InterruptedException {
        try {
            ours.add(reference.run().time(batch), count);
            return true;
        } catch (ChildLost lost) {
            reference.close();
            return false;
        }
    }

    /** An exception of the student's own is not named: its name may tell what it was thrown for. */
    private Optional<Message> obstacle(TopicGrading.Timing timing, StudentRun.Timed reply) {
        if (!reply.thrown().isEmpty())
            return Optional.of(
                    Answer.isOfTheJdk(reply.thrown())
                            ? Message.of(words.apply("speed.threw"), reply.thrown())
                            : Message.of(words.apply("speed.threw-own")));
        if (reply.tooLong()) return Optional.of(Message.of("speed.too-long"));
        boolean right = timing.mistakes(reply.told()).filter(charged::containsAll).isPresent();
        return right ? Optional.empty() : Optional.of(Message.of(words.apply("speed.wrong")));
    }
}
