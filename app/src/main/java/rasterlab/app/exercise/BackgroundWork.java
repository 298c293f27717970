package rasterlab.app.exercise;

import java.util.List;
import rasterlab.app.exercise.outcome.CaseResult;

/**
 * A task that runs in the background.
 *
 * @param done cases judged so far; in the queue of a server, the place in it, 0 when its turn has
 *     come
 * @param of cases in all; 0 where that is not known
 * @param cases those judged so far, without their verdicts: a mistake that all share is known only
 *     at the end, and is then paid for in the cases that ask for it alone
 */
public record BackgroundWork(Phase phase, int done, int of, List<CaseResult> cases) {
    public enum Phase {
        NONE,
        CHECKING,
        JOINING,
        READING,
        SENDING,
        WAITING,
        GRADING
    }

    public BackgroundWork {
        cases = CaseResult.numbered(cases.stream().map(CaseResult::withoutVerdict).toList());
    }

    public static final BackgroundWork NONE = of(Phase.NONE);

    public static BackgroundWork of(Phase phase) {
        return new BackgroundWork(phase, 0, 0, List.of());
    }

    /** Key of the notice that says what has become of work that is given up. */
    String givenUp() {
        return switch (phase) {
            case SENDING -> "cancelled.sending";
            case WAITING, GRADING -> "cancelled.handedIn";
            case NONE, CHECKING, JOINING, READING -> "cancelled";
        };
    }

    public boolean running() {
        return phase != Phase.NONE;
    }
}
