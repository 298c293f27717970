package rasterlab.app.row;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.NoAnswer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.study.WrongLength;

/**
 * The right answers for a topic's rows and those of methods; finding either takes longer than a
 * frame, so the event thread never asks.
 *
 * @param <C> contract of the topic's methods
 * @param <I> its input
 * @param <O> its output
 */
final class RowAnswers<C, I, O> {
    private final Topic<C, I, O> topic;

    /** Right answers by the hazards' names; a right answer takes much longer than any method's. */
    private final Map<String, O> rights = new ConcurrentHashMap<>();

    /**
     * @param actual empty where the method refused or crashed, of which the verdict tells why
     */
    record RowAnswer<O>(O exact, Optional<O> actual, Verdict verdict) {}

    RowAnswers(Topic<C, I, O> topic) {
        this.topic = topic;
    }

    /** The right answer, asked for on any thread but the event thread, as all of this class. */
    O right(Hazard<I> hazard) {
        return rights.computeIfAbsent(
                hazard.name(), name -> topic.exact(hazard.input(), Integer.MAX_VALUE));
    }

    /**
     * @throws IllegalArgumentException if there is no such method
     */
    RowAnswer<O> answer(Hazard<I> hazard, String method) {
        O exact = right(hazard);
        C implementation = topic.method(method).implementation();
        try {
            O actual = topic.record(implementation, hazard.input(), Integer.MAX_VALUE);
            Deviation deviation = topic.compare(hazard.input(), exact, actual);
            return new RowAnswer<>(exact, Optional.of(actual), verdict(deviation));
        } catch (NoAnswer none) {
            return without(exact, none.kind(), none.getMessage());
        } catch (WrongLength length) {
            NoAnswer none = OwnMethods.misshapen(length);
            return without(exact, none.kind(), none.getMessage());
        } catch (IllegalArgumentException refusal) {
            return without(exact, Verdict.Kind.REFUSED, refusal.getMessage());
        } catch (RuntimeException crash) {
            return without(exact, Verdict.Kind.CRASHED, crash.toString());
        }
    }

    private static <O> RowAnswer<O> without(O exact, Verdict.Kind kind, String detail) {
        return new RowAnswer<>(exact, Optional.empty(), new Verdict(kind, Deviation.NONE, detail));
    }

    private Verdict verdict(Deviation deviation) {
        Verdict.Kind kind =
                topic.correct(deviation)
                        ? Verdict.Kind.EXACT
                        : topic.usable(deviation) ? Verdict.Kind.DEGRADED : Verdict.Kind.WRONG;
        return new Verdict(kind, deviation, deviation.first());
    }
}
