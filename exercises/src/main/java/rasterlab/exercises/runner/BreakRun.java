package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Breaking;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.breaking.HandedInputs;
import rasterlab.exercises.judging.MethodsOnInput.MethodResult;
import rasterlab.exercises.runner.process.Child;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Launcher;
import rasterlab.exercises.runner.process.Programs;
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.ScorePoints;

/** Pays inputs for the faulty methods that fail on them while the right ones agree. */
final class BreakRun {
    /** All methods on one input may take as long as so many calls of a student's method. */
    private static final int CALLS = 6;

    private final JudgeSettings settings;
    private final Exercise exercise;
    private final Breaking rules;
    private final Launcher launcher;
    private final Consumer<CaseReport> progress;
    private final Map<String, Broken> broken = new LinkedHashMap<>();
    private final List<Diagnostic> said = new ArrayList<>();
    private boolean agreed;

    /**
     * The child for all inputs, until one takes too long; null before the first and after such a
     * one.
     */
    private Child child;

    BreakRun(
            JudgeSettings settings,
            Exercise exercise,
            Launcher launcher,
            Consumer<CaseReport> progress) {
        this.settings = settings;
        this.exercise = exercise;
        this.rules = exercise.breaking().orElseThrow();
        this.launcher = launcher;
        this.progress = progress;
    }

    /** The outcome of a faulty method, with its input. */
    private record Broken(MethodResult tried, String input, Message which) {}

    /**
     * @param sent a JSON object, or an array of them
     * @throws ChildLost when the process that tries the methods failed: our fault
     */
    Report run(String sent) throws ChildLost, InterruptedException {
        HandedInputs inputs;
        try {
            inputs = HandedInputs.of(exercise.topic(), sent, rules.inputs());
        } catch (CatalogueException invalid) {
            invalid.all().forEach(one -> said.add(diagnostic(one)));
            return report(GradingVerdict.REFUSED, List.of());
        }
        int number = 0;
        try {
            for (String input : inputs.inputs())
                tryOut(input, inputs.inputs().size() == 1 ? 0 : ++number);
        } finally {
            if (child != null) child.close();
        }
        return report(inputs.characters());
    }

    private static Diagnostic diagnostic(CatalogueException invalid) {
        return new Diagnostic(
                0, 0, Message.of("in-both-languages", invalid.in("en"), invalid.in("ru")));
    }

    /**
     * @param number of the input, from 1; 0 for an only one
     */
    private void tryOut(String input, int number) throws ChildLost, InterruptedException {
        Message which = number == 0 ? Message.NONE : Message.of("break.by", number);
        List<String> names = exercise.cases().stream().map(Case::name).toList();
        if (child == null)
            child = new Child(launcher.start(TriedMethods.command(Programs.java())), false);
        try {
            TriedMethods tried = TriedMethods.on(exercise.topic(), input, names, limit(), child);
            Message against = against(tried.right());
            if (against.isEmpty()) take(tried.faulty(), input, which);
            else said.add(new Diagnostic(0, 0, against.and(which)));
        } catch (ChildLost lost) {
            child.close();
            child = null;
            boolean large =
                    lost.reason() == ChildLost.LossReason.TIME
                            || lost.reason() == ChildLost.LossReason.MEMORY;
            if (!large || lost.isIdle()) throw lost;
            said.add(new Diagnostic(0, 0, Message.of("break.too-large").and(which)));
        }
    }

    private TimeLimit limit() {
        return settings.patience().limit(settings.callLimit().multipliedBy(CALLS));
    }

    private void take(List<MethodResult> faulty, String input, Message which) {
        agreed = true;
        for (MethodResult one : faulty)
            if (!broken.containsKey(one.method()) || better(one))
                broken.put(one.method(), new Broken(one, input, which));
    }

    private boolean better(MethodResult one) {
        return one.failed() && !broken.get(one.method()).tried().failed();
    }

    /** Why the right methods do not speak for this input; nothing where they do. */
    private static Message against(List<MethodResult> right) {
        for (MethodResult one : right)
            if (one.failed()) return Message.of("break.disagree", one.method()).and(one.message());
        return right.stream()
                .filter(one -> one.kind() == Verdict.Kind.REFUSED)
                .findFirst()
                .filter(one -> right.stream().allMatch(r -> r.kind() == Verdict.Kind.REFUSED))
                .map(one -> Message.of("break.all-refuse", one.method(), reason(one)))
                .orElse(Message.NONE);
    }

    /** The engine's words on why a method refuses. */
    private static String reason(MethodResult refused) {
        return refused.message().sentences().get(0).arguments().get(0);
    }

    private Report report(int characters) {
        List<CaseReport> cases = new ArrayList<>();
        for (Case one : exercise.cases())
            if (!one.name().equals(Breaking.SIZE)) add(cases, judged(one));
        add(cases, size(cases, characters));
        boolean all = cases.stream().allMatch(one -> one.verdict() == GradingVerdict.OK);
        return report(all ? GradingVerdict.OK : GradingVerdict.WRONG, cases);
    }

    private Report report(GradingVerdict verdict, List<CaseReport> cases) {
        int earned = cases.stream().mapToInt(CaseReport::points).sum();
        int possible = exercise.points().total();
        return new Report(
                verdict,
                new ScorePoints(earned, 0, 0, possible),
                cases,
                said,
                Report.PROCESS_LIMITS,
                0);
    }

    private void add(List<CaseReport> cases, CaseReport one) {
        cases.add(one);
        progress.accept(one);
    }

    private CaseReport judged(Case one) {
        Broken found = broken.get(one.name());
        if (found == null) return notTried(one);
        boolean failed = found.tried().failed();
        Message message =
                failed
                        ? found.tried().message().and(found.which())
                        : Message.of("break.withstands");
        String scene = new MethodCase(exercise.topic(), method(one.name()), found.input()).write();
        return new CaseReport(
                one.name(),
                Disclosure.OPEN,
                failed ? GradingVerdict.OK : GradingVerdict.WRONG,
                failed ? one.points() : 0,
                one.points(),
                message,
                List.of(),
                scene);
    }

    /** The lab shows a faulty method by its name; mutants are in no list of methods. */
    private Optional<String> method(String name) {
        return Topics.named(exercise.topic()).methods().stream()
                .map(Method::name)
                .filter(name::equals)
                .findFirst()
                .map(String::valueOf);
    }

    private static CaseReport notTried(Case one) {
        return new CaseReport(
                one.name(),
                Disclosure.OPEN,
                GradingVerdict.NOT_RUN,
                0,
                one.points(),
                Message.of("break.not-tried"),
                List.of(),
                "");
    }

    /** Pays for small inputs in the measure in which they break what there is. */
    private CaseReport size(List<CaseReport> targets, int characters) {
        int most = rules.sizePoints();
        int possible = targets.stream().mapToInt(CaseReport::of).sum();
        int earned = targets.stream().mapToInt(CaseReport::points).sum();
        double share = possible == 0 ? 0 : earned / (double) possible;
        int points = agreed ? (int) Math.round(share * rules.sizePoints(characters)) : 0;
        return new CaseReport(
                Breaking.SIZE,
                Disclosure.OPEN,
                points == most
                        ? GradingVerdict.OK
                        : agreed ? GradingVerdict.WRONG : GradingVerdict.NOT_RUN,
                points,
                most,
                Message.of("break.size", characters, rules.small(), rules.large()),
                List.of(),
                "");
    }
}
