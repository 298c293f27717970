package rasterlab.engine.study;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Gives a method its verdict on one input: runs it under guard and compares with the exact answer.
 *
 * <p>A long answer is compared by the part that {@link Topic#exactPart} chooses, and one that still
 * has more than {@link Topic#mostItems} items by its first so many. A method is endless when it
 * produces more than twice the exact items and 1,000 more, or goes beyond the wall limit, to which
 * time that it waits for a processor does not count, see {@link Guard}.
 */
public final class HazardTrial {
    /** The wall limit where somebody waits for the verdict: no right method comes near it. */
    public static final Duration WALL_LIMIT = Duration.ofSeconds(5);

    private HazardTrial() {}

    /**
     * One cell of the method × hazard table.
     *
     * @param recorded the kind written down in the hazard; exact where none is
     */
    public record VerdictCell(
            String hazard, String method, Verdict verdict, Verdict.Kind recorded) {
        /** Whether the method did what is written down. */
        public boolean asRecorded() {
            return verdict.kind() == recorded;
        }
    }

    /**
     * The answer of a method to an input, beside the right one.
     *
     * @param exact the right answer, cut where {@link Topic#mostItems} says
     * @param made the method's; empty where it gave none
     * @param thrown by the method in place of an answer; empty where it threw nothing
     */
    public record MethodAnswer<O>(
            O exact, Optional<O> made, Optional<Throwable> thrown, Verdict verdict) {}

    /** Every method on every hazard, hazard by hazard. */
    public static <C, I, O> List<VerdictCell> table(Topic<C, I, O> topic, Duration wallLimit) {
        return table(topic, wallLimit, cell -> {}, () -> false);
    }

    /**
     * Tries every method on every hazard, hazard by hazard, and tells each cell as it is judged.
     *
     * @param judged told each cell, on the caller's thread
     * @param cancelled asked before each cell
     * @throws CancellationException when {@code cancelled} says so or the thread is interrupted
     */
    public static <C, I, O> List<VerdictCell> table(
            Topic<C, I, O> topic,
            Duration wallLimit,
            Consumer<VerdictCell> judged,
            BooleanSupplier cancelled) {
        var cells = new ArrayList<VerdictCell>();
        for (Hazard<I> hazard : topic.hazards()) {
            ExactAnswer<O> answer = ExactAnswer.to(topic, hazard.input());
            for (Method<C> method : topic.methods()) {
                if (cancelled.getAsBoolean())
                    throw new CancellationException(
                            "hazards of '" + topic.name() + "' were cancelled");
                Verdict verdict = judge(topic, method, hazard.input(), answer, wallLimit);
                Verdict.Kind recorded =
                        hazard.recorded().getOrDefault(method.name(), Verdict.Kind.EXACT);
                cells.add(new VerdictCell(hazard.name(), method.name(), verdict, recorded));
                judged.accept(cells.get(cells.size() - 1));
            }
        }
        return cells;
    }

    /**
     * The verdict on {@code method} for {@code hazard}.
     *
     * @param wallLimit the longest it may take
     */
    public static <C, I, O> Verdict judge(
            Topic<C, I, O> topic, Method<C> method, Hazard<I> hazard, Duration wallLimit) {
        return tried(topic, method, hazard.input(), wallLimit).verdict();
    }

    /**
     * Judges methods on {@code input}, whose right answer is worked out once for all of them.
     *
     * @param wallLimit the longest each may take
     */
    public static <C, I, O> Function<Method<C>, Verdict> judging(
            Topic<C, I, O> topic, I input, Duration wallLimit) {
        return trying(topic, input, wallLimit).andThen(MethodAnswer::verdict);
    }

    /**
     * The verdict on {@code method} for an input, with what the method made of it.
     *
     * @param wallLimit the longest it may take
     */
    public static <C, I, O> MethodAnswer<O> tried(
            Topic<C, I, O> topic, Method<C> method, I input, Duration wallLimit) {
        return tried(topic, method, input, ExactAnswer.to(topic, input), wallLimit);
    }

    /**
     * Tries methods on {@code input}, whose right answer is worked out once for all of them.
     *
     * @param wallLimit the longest each may take
     */
    public static <C, I, O> Function<Method<C>, MethodAnswer<O>> trying(
            Topic<C, I, O> topic, I input, Duration wallLimit) {
        ExactAnswer<O> answer = ExactAnswer.to(topic, input);
        return method -> tried(topic, method, input, answer, wallLimit);
    }

    static <C, I, O> Verdict judge(
            Topic<C, I, O> topic,
            Method<C> method,
            I input,
            ExactAnswer<O> answer,
            Duration wallLimit) {
        return tried(topic, method, input, answer, wallLimit).verdict();
    }

    private static <C, I, O> MethodAnswer<O> tried(
            Topic<C, I, O> topic,
            Method<C> method,
            I input,
            ExactAnswer<O> answer,
            Duration wallLimit) {
        var outcome =
                Guard.call(
                        "trial of " + method.name(),
                        () -> topic.recordPart(method.implementation(), input, answer.limit()),
                        wallLimit);
        if (outcome instanceof Guard.Returned<O> returned)
            return compared(topic, input, answer.exact(), returned.value());
        if (outcome instanceof Guard.Failed<O> threw
                && threw.cause() instanceof LimitReached reached)
            return answer.cut()
                    ? compared(topic, input, answer.exact(), recorded(reached))
                    : without(answer, Optional.empty(), endless(answer, topic.item()));
        Optional<Throwable> thrown =
                outcome instanceof Guard.Failed<O> threw
                        ? Optional.of(threw.cause())
                        : Optional.empty();
        return without(answer, thrown, Verdicts.ofFailure(outcome));
    }

    private static <O> MethodAnswer<O> without(
            ExactAnswer<O> answer, Optional<Throwable> thrown, Verdict verdict) {
        return new MethodAnswer<>(answer.exact(), Optional.empty(), thrown, verdict);
    }

    private static Verdict endless(ExactAnswer<?> answer, String item) {
        return new Verdict(
                Verdict.Kind.ENDLESS,
                Deviation.NONE,
                "still going after "
                        + answer.limit()
                        + " "
                        + item
                        + "s where "
                        + answer.items()
                        + " are right");
    }

    private static <C, I, O> MethodAnswer<O> compared(
            Topic<C, I, O> topic, I input, O exact, O actual) {
        // A method that somebody wrote may answer with null, which the comparison judges.
        Verdict verdict = verdict(topic, input, exact, actual);
        return new MethodAnswer<>(exact, Optional.ofNullable(actual), Optional.empty(), verdict);
    }

    private static <C, I, O> Verdict verdict(Topic<C, I, O> topic, I input, O exact, O actual) {
        Deviation deviation;
        try {
            deviation = topic.compare(input, exact, actual);
        } catch (RuntimeException e) {
            // The exact answer was compared with itself before, so this is the method's fault.
            return Verdicts.ofAnswer(e);
        }
        Verdict.Kind kind =
                topic.correct(deviation)
                        ? Verdict.Kind.EXACT
                        : topic.usable(deviation) ? Verdict.Kind.DEGRADED : Verdict.Kind.WRONG;
        return new Verdict(kind, deviation, deviation.first());
    }

    @SuppressWarnings("unchecked") // the topic's own sink threw it, with the topic's output
    private static <O> O recorded(LimitReached reached) {
        return (O) reached.recorded();
    }
}
