package rasterlab.exercises.marking;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Finding;

/**
 * One case and its calls.
 *
 * @param calls as far as they were tried
 * @param untried why no call was tried; nothing where some were
 */
public record CaseTrial(Case one, List<TriedCall> calls, Optional<Finding> untried) {
    public CaseTrial {
        calls = List.copyOf(calls);
        if (calls.isEmpty() == untried.isEmpty())
            throw new IllegalArgumentException(
                    "case '" + one.name() + "' must either be tried or have a reason why not");
    }

    public static CaseTrial tried(Case one, List<TriedCall> calls) {
        return new CaseTrial(one, calls, Optional.empty());
    }

    public static CaseTrial untried(Case one, Finding reason) {
        return new CaseTrial(one, List.of(), Optional.of(reason));
    }

    /** This trial with some calls replaced. */
    public CaseTrial with(Map<TriedCall, TriedCall> replaced) {
        return tried(one, calls.stream().map(call -> replaced.getOrDefault(call, call)).toList());
    }

    boolean open() {
        return one.visibility() == Disclosure.OPEN;
    }

    boolean refused() {
        return calls.stream().anyMatch(TriedCall::refused);
    }
}
