package rasterlab.exercises.marking;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/**
 * Counts what the tried cases are worth.
 *
 * <p>A case pays unless one of its calls is wrong for a mistake that counts there ({@link
 * Charges}). A public case pays only where half of its group's hidden calls are right, and a
 * refusal only where the group's other cases are, so that neither a table of the public cases nor a
 * method that refuses everything earns anything.
 */
public final class Marking {
    private final Exercise exercise;
    private final List<TriedCase> cases = new ArrayList<>();
    private final Map<TriedCall, Finding> shown = new IdentityHashMap<>();
    private Charges charges;

    public Marking(Exercise exercise) {
        this.exercise = exercise;
        this.charges = new Charges(exercise, cases);
    }

    /** Its line by what is known now, which later cases may change. */
    public CaseReport add(TriedCase tried) {
        put(tried);
        return report(tried);
    }

    /** Adds a case, or what more is known of one. */
    public void put(TriedCase tried) {
        int known = names().indexOf(tried.one().name());
        if (known < 0) cases.add(tried);
        else cases.set(known, tried);
        charges = new Charges(exercise, cases);
    }

    /** The added cases, in order. */
    public List<TriedCase> cases() {
        return List.copyOf(cases);
    }

    private List<String> names() {
        return cases.stream().map(tried -> tried.one().name()).toList();
    }

    /** Names of the cases that pay. */
    public List<String> paying() {
        return cases.stream()
                .filter(tried -> passes(tried) && unearned(tried).isEmpty())
                .map(tried -> tried.one().name())
                .toList();
    }

    /** Codes of the mistakes that were paid for. */
    public Set<String> charged() {
        return charges.charged();
    }

    /** Traits of the inputs whose answer is wrong for a reason that was not paid for. */
    public List<Set<String>> uncharged() {
        return cases.stream()
                .flatMap(tried -> tried.calls().stream())
                .filter(call -> !call.right() && !charges.explain(call))
                .map(call -> call.call().traits())
                .distinct()
                .toList();
    }

    /** One line for each case, in their order. */
    public List<CaseReport> reports() {
        List<CaseReport> reports = new ArrayList<>();
        for (TriedCase tried : cases) reports.add(report(tried));
        return reports;
    }

    /** One mistake that explains all that is wrong, if there is one; else nothing. */
    public Message shared() {
        return new SharedCause(cases).said();
    }

    private CaseReport report(TriedCase tried) {
        if (tried.untried().isPresent()) return report(tried.one(), tried.untried().get(), "");
        Optional<TriedCall> wrong = charges.first(tried);
        if (wrong.isPresent()) {
            Finding finding = shown.computeIfAbsent(wrong.get(), TriedCall::shown);
            return report(tried.one(), finding, wrong.get().scene());
        }
        return report(tried.one(), unearned(tried).orElse(Finding.OK), scene(tried));
    }

    private static String scene(TriedCase tried) {
        return tried.calls().get(0).call().scene();
    }

    /** Why a case whose own calls are right pays nothing; empty where it pays. */
    private Optional<Finding> unearned(TriedCase tried) {
        if (tried.refused() && !othersAreRight(tried.one()))
            return Optional.of(
                    Finding.of(GradingVerdict.RUNTIME_ERROR, Message.of("group.refused")));
        if (tried.open() && !holdsOnHidden(tried.one()))
            return Optional.of(Finding.of(GradingVerdict.WRONG, Message.of("group.hidden")));
        return Optional.empty();
    }

    /**
     * Whether the cases of the same group that were drawn, not refused, are all right; where there
     * is none, whether any case of the exercise is.
     */
    private boolean othersAreRight(Case one) {
        List<TriedCase> others = drawn(inGroupOf(one));
        return others.isEmpty()
                ? drawn(tried -> true).stream().anyMatch(this::passes)
                : others.stream().allMatch(this::passes);
    }

    private List<TriedCase> drawn(Predicate<TriedCase> wanted) {
        return cases.stream().filter(wanted).filter(tried -> !tried.refused()).toList();
    }

    /**
     * Whether at least half of the group's hidden calls are right; where no hidden case was tried,
     * nothing speaks against.
     */
    private boolean holdsOnHidden(Case one) {
        List<TriedCase> hidden =
                cases.stream().filter(inGroupOf(one)).filter(tried -> !tried.open()).toList();
        long all = hidden.stream().mapToLong(tried -> Math.max(1, tried.calls().size())).sum();
        return 2 * hidden.stream().mapToLong(this::rightCalls).sum() >= all;
    }

    private long rightCalls(TriedCase tried) {
        if (tried.refused() && !othersAreRight(tried.one())) return 0;
        return tried.calls().size() - charges.counted(tried).size();
    }

    private static Predicate<TriedCase> inGroupOf(Case one) {
        return tried -> tried.one().group().equals(one.group());
    }

    private boolean passes(TriedCase tried) {
        return tried.untried().isEmpty() && charges.counted(tried).isEmpty();
    }

    private static CaseReport report(Case one, Finding finding, String scene) {
        return new CaseReport(
                one.name(),
                one.visibility(),
                finding.verdict(),
                finding.right() ? one.points() : 0,
                one.points(),
                finding.said(),
                finding.pictures(),
                scene);
    }
}
