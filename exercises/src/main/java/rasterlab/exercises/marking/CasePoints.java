package rasterlab.exercises.marking;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** The worth of cases as far as it follows from the given ones alone. */
final class CasePoints {
    private final List<CaseTrial> cases;
    private final Charges charges;

    CasePoints(List<CaseTrial> cases, Charges charges) {
        this.cases = List.copyOf(cases);
        this.charges = charges;
    }

    Charges charges() {
        return charges;
    }

    boolean pays(CaseTrial tried) {
        return passes(tried) && unearned(tried).isEmpty();
    }

    private boolean passes(CaseTrial tried) {
        return tried.untried().isEmpty() && charges.counted(tried).isEmpty();
    }

    /** Why a case whose own calls are right pays nothing; empty where it pays. */
    Optional<Finding> unearned(CaseTrial tried) {
        return isRefusalAlone(tried)
                ? Optional.of(Finding.of(GradingVerdict.RUNTIME_ERROR, Message.of("group.refused")))
                : Optional.empty();
    }

    /** A refusal pays only where the other cases of its group are right. */
    private boolean isRefusalAlone(CaseTrial tried) {
        return tried.refused() && !othersAreRight(tried.one());
    }

    /**
     * Whether the cases of the same group that were drawn, not refused, are all right; where there
     * is none, whether any case is.
     */
    private boolean othersAreRight(Case one) {
        List<CaseTrial> others = drawn(inGroupOf(one));
        return others.isEmpty()
                ? drawn(tried -> true).stream().anyMatch(this::passes)
                : others.stream().allMatch(this::passes);
    }

    private List<CaseTrial> drawn(Predicate<CaseTrial> wanted) {
        return cases.stream().filter(wanted).filter(tried -> !tried.refused()).toList();
    }

    /** Whether the hidden cases let a public case pay that is right by itself. */
    boolean holdsOnHidden(CaseTrial tried) {
        return !isRefusalAlone(tried) && halfOfHiddenIsRight(tried.one());
    }

    /**
     * Whether at least half of the group's hidden calls are right; where no hidden case was tried,
     * nothing speaks against.
     */
    private boolean halfOfHiddenIsRight(Case one) {
        List<CaseTrial> hidden =
                cases.stream().filter(inGroupOf(one)).filter(tried -> !tried.open()).toList();
        long all = hidden.stream().mapToLong(tried -> Math.max(1, tried.calls().size())).sum();
        return 2 * hidden.stream().mapToLong(this::rightCalls).sum() >= all;
    }

    private long rightCalls(CaseTrial tried) {
        if (isRefusalAlone(tried)) return 0;
        return tried.calls().size() - charges.counted(tried).size();
    }

    private static Predicate<CaseTrial> inGroupOf(Case one) {
        return tried -> tried.one().group().equals(one.group());
    }
}
