package rasterlab.exercises.marking;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.exercises.score.Cause;

/**
 * Finds out whether a program does nothing: each of its answers is one of a method that does
 * nothing. It makes no other mistake, though many a known one leaves nothing of some input, too.
 */
final class IdleProgram {
    private final Map<TriedCall, Optional<Cause>> known = new IdentityHashMap<>();

    /**
     * The mistake of such a program; empty where an answer is of another kind, or none is wrong.
     */
    Optional<Cause> mistake(List<CaseTrial> cases) {
        Optional<Cause> mistake = Optional.empty();
        for (CaseTrial tried : cases)
            for (TriedCall call : tried.calls()) {
                if (!call.answered()) continue;
                Optional<Cause> idle = known.computeIfAbsent(call, TriedCall::idle);
                if (idle.isEmpty()) return Optional.empty();
                if (mistake.isEmpty() && !call.right()) mistake = idle;
            }
        return mistake;
    }
}
