package rasterlab.exercises.runner;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/**
 * A student's method, in a fresh child whenever it was stopped, until that happened too often or
 * all calls together took too long.
 */
final class Student implements AutoCloseable, Shrinking.Asking {
    /** Stopped calls after which no more is asked of it. */
    static final int MOST_STOPS = 5;

    /** A call that does not count takes no longer than all such calls may. */
    private static final Exercise.StatedLimits ASIDE =
            new Exercise.StatedLimits(
                    OptionalInt.empty(), OptionalInt.empty(), Optional.of(Shrinking.MOST_TIME));

    /** Processor time for the start of a child, far more than one needs. */
    private static final Duration START_LIMIT = Duration.ofSeconds(10);

    private final Children children;
    private final JudgeSettings settings;
    private final ContractCalls contract;
    private final Exercise.StatedLimits caps;
    private final String entry;
    private final Map<String, byte[]> classes;
    private final boolean again;
    private Optional<Loaded> loaded = Optional.empty();
    private Duration spent = Duration.ZERO;
    private Duration spentAside = Duration.ZERO;
    private int stops;
    private int answered;

    /** A child and what it answered to the classes. */
    private record Loaded(Child child, StudentRun run) {}

    /**
     * @param contract that the class implements
     * @param caps limits of a call that the exercise states
     * @param entry name of the class that implements the contract
     * @param again whether this was tried before: then a signal is no accident but what the method
     *     makes of its process
     */
    Student(
            Children children,
            JudgeSettings settings,
            ContractCalls contract,
            Exercise.StatedLimits caps,
            String entry,
            Map<String, byte[]> classes,
            boolean again) {
        this.children = children;
        this.settings = settings;
        this.contract = contract;
        this.caps = caps;
        this.entry = entry;
        this.classes = classes;
        this.again = again;
    }

    /** Why nothing more is asked; empty as long as something is. */
    Optional<Finding> over() {
        if (stops >= MOST_STOPS) return notRun("not-run.stops", stops);
        return spent.compareTo(settings.runLimit()) >= 0
                ? notRun("not-run.time", Child.seconds(settings.runLimit()))
                : Optional.empty();
    }

    private static Optional<Finding> notRun(String key, Object argument) {
        return Optional.of(Finding.of(GradingVerdict.NOT_RUN, Message.of(key, argument)));
    }

    /** All is asked once more, of a fresh child; the time of all calls counts from now on. */
    void beginAnew() {
        close();
        spent = Duration.ZERO;
    }

    /**
     * The number of calls that the child as it is has answered; none where the last was stopped.
     */
    int answered() {
        return loaded.isEmpty() ? 0 : answered;
    }

    /**
     * Starts a child and loads the classes.
     *
     * @return why that fails; empty where it does not
     * @throws ChildLost when the child was killed from outside: no fault of the student's
     */
    Optional<Finding> load() throws ChildLost, InterruptedException {
        try {
            return twice(this::loadOnce);
        } catch (ChildLost lost) {
            return Optional.of(stopped(lost));
        }
    }

    private Optional<Finding> loadOnce() throws ChildLost, InterruptedException {
        close();
        answered = 0;
        Child child = children.takeReady(ChildKind.RUN, settings.patience().limit(START_LIMIT));
        StudentRun run = new StudentRun(child, contract, settings.callLimit(), settings.patience());
        loaded = Optional.of(new Loaded(child, run));
        Answer answer = run.load(entry, classes);
        return answer.ending() == Answer.CallEnding.THREW
                ? Optional.of(
                        Finding.of(
                                GradingVerdict.RUNTIME_ERROR,
                                Message.of("creating", answer.thrown()).and(answer.place())))
                : Optional.empty();
    }

    /** One call, in a fresh child where the last was stopped. */
    TriedCall call(GradedCall call) throws ChildLost, InterruptedException {
        try {
            return TriedCall.answered(call, twice(() -> answer(call)));
        } catch (ChildLost lost) {
            return TriedCall.failed(call, stopped(lost));
        } catch (NotLoaded fault) {
            stops++;
            return TriedCall.failed(call, fault.finding);
        }
    }

    /** {@inheritDoc} Neither its time nor its end counts. */
    @Override
    public Optional<TriedCall> aside(GradedCall call) throws InterruptedException {
        if (loaded.isEmpty()) return Optional.empty();
        StudentRun run = loaded.get().run();
        Duration before = run.used();
        try {
            Answer answer = run.call(call, call.caps().within(caps).within(ASIDE));
            spentAside = spentAside.plus(run.used()).minus(before);
            if (run.over()) close();
            return Optional.of(TriedCall.answered(call, answer));
        } catch (ChildLost lost) {
            close();
            return Optional.empty();
        }
    }

    @Override
    public Duration spentAside() {
        return spentAside;
    }

    private Answer answer(GradedCall call) throws ChildLost, InterruptedException {
        if (loaded.isEmpty()) {
            Optional<Finding> fault = loadOnce();
            if (fault.isPresent()) throw new NotLoaded(fault.get());
        }
        StudentRun run = loaded.orElseThrow().run();
        Duration before = run.used();
        Answer answer = run.call(call, call.caps().within(caps));
        spent = spent.plus(run.used()).minus(before);
        answered++;
        if (run.over()) {
            stops++;
            close();
        }
        return answer;
    }

    /** The classes could be loaded before, but not in a fresh child. */
    private static final class NotLoaded extends RuntimeException {
        private static final long serialVersionUID = 1L;
        private final transient Finding finding;

        NotLoaded(Finding finding) {
            super(finding.message().toString(), null, false, false);
            this.finding = finding;
        }
    }

    /** Something that is asked of a child. */
    private interface ChildRequest<T> {
        T ask() throws ChildLost, InterruptedException;
    }

    /** Asks again, in a fresh child, where the child did nearly nothing with its time. */
    private <T> T twice(ChildRequest<T> asked) throws ChildLost, InterruptedException {
        try {
            return asked.ask();
        } catch (ChildLost lost) {
            close();
            if (!lost.isIdle()) throw lost;
            return asked.ask();
        }
    }

    private Finding stopped(ChildLost lost) throws ChildLost {
        close();
        Finding finding = finding(lost);
        stops++;
        return finding;
    }

    /**
     * @throws ChildLost when the child was killed from outside: no fault of the student's
     */
    private Finding finding(ChildLost lost) throws ChildLost {
        if (lost.isOursToRepeat(again)) throw lost;
        GradingVerdict verdict =
                switch (lost.reason()) {
                    case TIME -> GradingVerdict.TIME_LIMIT;
                    case MEMORY -> GradingVerdict.MEMORY_LIMIT;
                    case OUTPUT -> GradingVerdict.OUTPUT_LIMIT;
                    case ENDED, PROTOCOL, SIGNAL, KILLED -> GradingVerdict.NO_RESULT;
                };
        return Finding.of(verdict, lost.message());
    }

    /**
     * The child as it is, for something else than a call; a fresh one where the last was stopped.
     */
    StudentRun run() throws ChildLost, InterruptedException {
        if (loaded.isEmpty() && loadOnce().isPresent())
            throw new ChildLost(ChildLost.LossReason.ENDED, Message.of("child.no-load"));
        return loaded.orElseThrow().run();
    }

    /** Ends the child; the next call starts another. */
    @Override
    public void close() {
        loaded.ifPresent(one -> one.child().close());
        loaded = Optional.empty();
    }
}
