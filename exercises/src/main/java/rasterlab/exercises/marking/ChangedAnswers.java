package rasterlab.exercises.marking;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.KnownChanges;

/**
 * Finds the one change of the right answers by which all answers of a program come. One wrong
 * answer may look like a change by chance; that all do, and that the right ones are right with it,
 * is none.
 */
final class ChangedAnswers {
    private final Optional<Cause> only;

    ChangedAnswers(List<CaseTrial> cases) {
        List<TriedCall> calls = cases.stream().flatMap(one -> one.calls().stream()).toList();
        List<Cause> left =
                changes(calls).stream()
                        .filter(one -> calls.stream().allMatch(call -> call.fits(one.code())))
                        .toList();
        only = left.size() == 1 ? Optional.of(left.get(0)) : Optional.empty();
    }

    private static Set<Cause> changes(List<TriedCall> calls) {
        Set<Cause> changes = new LinkedHashSet<>();
        for (TriedCall call : calls)
            if (!call.right())
                for (List<Cause> one : call.finding().explanations())
                    if (one.size() == 1 && KnownChanges.isOne(one.get(0).code()))
                        changes.add(one.get(0));
        return changes;
    }

    /** The change; empty where there is none, or several are left. */
    Optional<Cause> only() {
        return only;
    }

    /** Whether that explains the answer by itself. */
    boolean explains(TriedCall call) {
        return only.filter(
                        one ->
                                call.finding().explanations().stream()
                                        .anyMatch(List.of(one)::equals))
                .isPresent();
    }
}
