package rasterlab.exercises.marking;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/**
 * Counts what the tried cases are worth.
 *
 * <p>A case pays unless one of its calls is wrong for a mistake that counts there ({@link
 * Charges}). What is said of a public case, and its points, follow from the public cases alone, so
 * that a student sees the same wherever they are tried. Points of public cases pay only where half
 * of their group's hidden calls are right, and a refusal only where the group's other cases are, so
 * that neither a table of the public cases nor a method that refuses everything earns anything:
 * what does not pay is taken off by a line of its own ({@link #withheld}).
 */
public final class Marking {
    private final Exercise exercise;
    private final List<CaseTrial> cases = new ArrayList<>();
    private final Map<TriedCall, Finding> shown = new IdentityHashMap<>();
    private CasePoints byAll;
    private CasePoints byOpen;
    private final IdleProgram program = new IdleProgram();
    private Optional<Cause> idle = Optional.empty();

    public Marking(Exercise exercise) {
        this.exercise = exercise;
        weigh();
    }

    private void weigh() {
        List<CaseTrial> open = cases.stream().filter(CaseTrial::open).toList();
        byAll = new CasePoints(cases, Charges.wherever(exercise, cases));
        byOpen = new CasePoints(open, Charges.once(exercise, open));
        Optional<Cause> now = program.mistake(cases);
        if (!now.equals(idle)) shown.clear();
        idle = now;
    }

    /** Adds a case and gives its line by what is known now, which later cases may change. */
    public CaseReport add(CaseTrial tried) {
        put(tried);
        return report(tried, Optional.empty());
    }

    /** Adds a case, or what more is known of one. */
    public void put(CaseTrial tried) {
        int known = names().indexOf(tried.one().name());
        if (known < 0) cases.add(tried);
        else cases.set(known, tried);
        weigh();
    }

    /** The added cases, in order. */
    public List<CaseTrial> cases() {
        return List.copyOf(cases);
    }

    private List<String> names() {
        return cases.stream().map(tried -> tried.one().name()).toList();
    }

    /** Names of the cases that pay. */
    public List<String> paying() {
        return cases.stream()
                .filter(tried -> worth(tried).pays(tried) && !isWithheld(tried))
                .map(tried -> tried.one().name())
                .toList();
    }

    /** The public cases that are right and yet pay nothing, for the hidden ones are not. */
    public List<Case> withheld() {
        return cases.stream().filter(this::isWithheld).map(CaseTrial::one).toList();
    }

    private boolean isWithheld(CaseTrial tried) {
        return tried.open() && byOpen.pays(tried) && !byAll.holdsOnHidden(tried);
    }

    private CasePoints worth(CaseTrial tried) {
        return tried.open() ? byOpen : byAll;
    }

    /** Codes of the mistakes that were paid for. */
    public Set<String> charged() {
        return byAll.charges().charged();
    }

    /** Traits of the inputs whose answer is wrong for a reason that was not paid for. */
    public List<Set<String>> uncharged() {
        return cases.stream()
                .flatMap(tried -> tried.calls().stream())
                .filter(call -> !call.right() && !byAll.charges().explain(call))
                .map(call -> call.inQuestion().traits())
                .distinct()
                .toList();
    }

    /** One line for each case, in their order. */
    public List<CaseReport> reports() {
        List<CaseReport> reports = new ArrayList<>();
        var open = new Suspects(cases.stream().filter(CaseTrial::open).toList());
        var all = new Suspects(cases);
        for (CaseTrial tried : cases)
            reports.add(report(tried, Optional.of(tried.open() ? open : all)));
        return reports;
    }

    /**
     * One mistake that explains all that is wrong, if there is one; else nothing. Of a program that
     * does nothing, that, and the one known mistake by which that comes, if there is one.
     */
    public Message shared() {
        var cause = new SharedCause(cases);
        return idle.map(one -> Message.of("cause.shared").and(one.message()).and(cause.only()))
                .orElseGet(cause::message);
    }

    /**
     * @param suspects tells which of several mistakes was made; empty where that is not asked yet
     */
    private CaseReport report(CaseTrial tried, Optional<Suspects> suspects) {
        if (tried.untried().isPresent()) return report(tried.one(), tried.untried().get(), "");
        Optional<TriedCall> wrong = worth(tried).charges().first(tried);
        if (wrong.isPresent()) {
            Finding finding = shown.computeIfAbsent(wrong.get(), this::shown);
            Message only =
                    suspects.filter(any -> idle.isEmpty())
                            .map(one -> one.only(wrong.get(), finding.message()))
                            .orElse(Message.NONE);
            return report(tried.one(), finding.and(only), wrong.get().scene());
        }
        return report(
                tried.one(),
                worth(tried).unearned(tried).orElseGet(() -> held(tried)),
                scene(tried));
    }

    private Finding shown(TriedCall wrong) {
        return idle.map(wrong::shown).orElseGet(wrong::shown);
    }

    /** Nothing is told of a case whose mistakes are paid for elsewhere. */
    private static Finding held(CaseTrial tried) {
        if (!tried.calls().stream().allMatch(TriedCall::right)) return Finding.OK;
        return Finding.of(GradingVerdict.OK, tried.calls().get(0).call().held());
    }

    private static String scene(CaseTrial tried) {
        return tried.calls().get(0).call().scene();
    }

    private static CaseReport report(Case one, Finding finding, String scene) {
        return new CaseReport(
                one.name(),
                one.visibility(),
                finding.verdict(),
                finding.right() ? one.points() : 0,
                one.points(),
                finding.message(),
                finding.pictures(),
                scene);
    }
}
