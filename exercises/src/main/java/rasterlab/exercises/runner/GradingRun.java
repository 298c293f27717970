package rasterlab.exercises.runner;

import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.marking.CaseTrial;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.TimeLimit;
import rasterlab.exercises.runner.scan.AllowList;
import rasterlab.exercises.runner.scan.ByteCodeCheck;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.SpeedFigures;
import rasterlab.exercises.score.SpeedPoints;
import rasterlab.exercises.topic.TopicGradings;

/** One grading, each try with children of its own. */
final class GradingRun {
    private final JudgeSettings settings;
    private final Exercise exercise;
    private final TopicGrading topic;
    private final ContractCalls contract;
    private final String source;
    private final CaseSelection selection;
    private final Consumer<CaseReport> progress;
    private final ReportSheet sheet;
    private final SpeedMemory memory;
    private final Models models;
    private boolean tried;
    private boolean again;
    private Optional<SpeedFigures> figures = Optional.empty();

    GradingRun(
            JudgeSettings settings,
            Exercise exercise,
            String source,
            CaseSelection selection,
            Consumer<CaseReport> progress,
            ReportSheet sheet,
            SpeedMemory memory,
            Models models) {
        this.settings = settings;
        this.exercise = exercise;
        this.topic = TopicGradings.of(exercise);
        this.contract = ContractCalls.of(topic.contract());
        this.source = source;
        this.selection = selection;
        this.progress = progress;
        this.sheet = sheet;
        this.memory = memory;
        this.models = models;
    }

    /**
     * The cases to try: the open ones come first, so that what they print tells no hidden input.
     */
    static List<Case> selected(Exercise exercise, CaseSelection selection) {
        return exercise.cases().stream()
                .filter(one -> selection.hidden() || one.visibility() == Disclosure.OPEN)
                .sorted(Comparator.comparing(one -> one.visibility() != Disclosure.OPEN))
                .toList();
    }

    /**
     * @throws ChildLost when a child was killed from outside or could not work: our fault
     */
    Report run(Children children, Compiling compiling) throws ChildLost, InterruptedException {
        again = tried;
        tried = true;
        figures = Optional.empty();
        TimeLimit limit = settings.patience().limit(settings.compileLimit());
        Compilation compiled = compiling.compile(children, source, limit);
        if (compiled.verdict() != GradingVerdict.OK)
            return sheet.rejected(compiled.verdict(), compiled.errors());
        String name = topic.contract().getName().replace('.', '/');
        ByteCodeCheck.Result checked =
                new ByteCodeCheck(AllowList.of(topic.contract()))
                        .check(compiled.classes(), name, source);
        if (!checked.refusals().isEmpty())
            return sheet.rejected(GradingVerdict.REFUSED, checked.refusals());
        try (Student student = student(checked.entry(), compiled.classes(), children)) {
            return tried(student, children);
        }
    }

    private Student student(String entry, Map<String, byte[]> classes, Children children) {
        return new Student(children, settings, contract, exercise.caps(), entry, classes, again);
    }

    private Report tried(Student student, Children children)
            throws ChildLost, InterruptedException {
        CaseRun cases = new CaseRun(exercise, topic, selection.seed(), student);
        Marking marking = new Marking(exercise);
        Optional<Finding> unloaded = student.load();
        children.topUp(ChildKind.RUN);
        for (Case one : selected(exercise, selection))
            progress.accept(
                    marking.add(
                            unloaded.isPresent()
                                    ? untried(marking, one, unloaded.get())
                                    : cases.tryOut(one)));
        Optional<Models.Model> model = model(student, children, marking);
        List<GradedCall> again =
                cases.answered(marking.cases()).stream().map(TriedCall::call).toList();
        Optional<CallsBeside> beside =
                model.map(one -> student(one.entry(), one.classes(), children))
                        .map(reference -> new CallsBeside(reference, again));
        try {
            List<CaseTrial> differing = cases.repeat(marking.cases());
            differing.forEach(marking::put);
            return report(cases, marking, differing, speed(student, model, beside, cases, marking));
        } finally {
            try {
                beside.ifPresent(CallsBeside::close);
            } finally {
                beside.map(CallsBeside::reference).ifPresent(Student::close);
            }
        }
    }

    private Report report(
            CaseRun cases,
            Marking marking,
            List<CaseTrial> differing,
            SpeedTrial.SpeedOutcome speed) {
        List<CaseReport> reports = marking.reports();
        CaseReport speedReport = report(speed);
        progress.accept(speedReport);
        List<Diagnostic> said = new ArrayList<>();
        notRepeatable(differing).ifPresent(one -> said.add(new Diagnostic(0, 0, one)));
        Message shared = marking.shared();
        if (!shared.isEmpty()) said.add(new Diagnostic(0, 0, shared));
        said.addAll(cases.printed());
        double nanos = speed.unsettled() ? 0 : speed.nanosPerPixel();
        return sheet.graded(reports, marking.withheld(), speedReport, said, nanos).with(figures);
    }

    /**
     * The program that the method's speed is held against; empty where it is not measured, or
     * cannot be.
     */
    private Optional<Models.Model> model(Student student, Children children, Marking marking)
            throws ChildLost, InterruptedException {
        return settings.speed() == JudgeSettings.Speed.MEASURED && earnsSpeed(student, marking)
                ? models.of(exercise, topic, children, settings)
                : Optional.empty();
    }

    private boolean earnsSpeed(Student student, Marking marking) {
        return student.over().isEmpty() && aboveFloor(marking.reports(), marking.withheld());
    }

    /** The first case tells why the method cannot be loaded. */
    private static CaseTrial untried(Marking marking, Case one, Finding unloaded) {
        return CaseTrial.untried(
                one,
                marking.cases().isEmpty()
                        ? unloaded
                        : Finding.of(GradingVerdict.NOT_RUN, Message.of("not-run.load")));
    }

    /** The first input whose answer differed, where it may be told. */
    private static Optional<Message> notRepeatable(List<CaseTrial> differing) {
        if (differing.isEmpty()) return Optional.empty();
        Message input =
                differing.stream()
                        .filter(tried -> tried.one().visibility() == Disclosure.OPEN)
                        .flatMap(tried -> tried.calls().stream())
                        .filter(call -> call.answer().isEmpty())
                        .map(call -> call.call().example())
                        .findFirst()
                        .orElse(Message.of("where.hidden"));
        return Optional.of(Message.of("mistake.not-repeatable").and(input));
    }

    private CaseReport report(SpeedTrial.SpeedOutcome speed) {
        int most = exercise.points().speed();
        String key = SpeedMemory.key(exercise, source);
        OptionalInt before = memory.band(key);
        if (speed.unsettled()) {
            int known = before.orElse(0);
            return SpeedPoints.unsettled(
                    most, speed.isKnown() ? SpeedPoints.band(speed.leastRatio(), before) : known);
        }
        if (!speed.obstacle().isEmpty()) return SpeedPoints.none(most, speed.obstacle());
        int band = SpeedPoints.band(speed.leastRatio(), before);
        memory.keep(key, band);
        return SpeedPoints.measured(
                topic::inOwnWords,
                speed.nanosPerPixel(),
                speed.reference(),
                speed.printed(),
                most,
                band);
    }

    private static Message tooInaccurate() {
        return Message.of("speed.floor", Math.round(100 * SpeedPoints.ACCURACY_FLOOR));
    }

    private boolean aboveFloor(List<CaseReport> reports, List<Case> withheld) {
        List<String> accuracy =
                exercise.cases().stream()
                        .filter(one -> one.kind() == Criterion.ACCURACY)
                        .map(Case::name)
                        .toList();
        List<CaseReport> counted =
                reports.stream().filter(one -> accuracy.contains(one.name())).toList();
        int earned =
                counted.stream().mapToInt(CaseReport::points).sum()
                        - ReportSheet.sum(withheld, Criterion.ACCURACY);
        int possible = counted.stream().mapToInt(CaseReport::of).sum();
        return earned >= SpeedPoints.ACCURACY_FLOOR * possible;
    }

    /**
     * A method that is stopped while it is timed loses the points for speed only. Before, the
     * reference has drawn what the method has repeated, so that Java knows both equally well.
     */
    private SpeedTrial.SpeedOutcome speed(
            Student student,
            Optional<Models.Model> model,
            Optional<CallsBeside> beside,
            CaseRun cases,
            Marking marking)
            throws ChildLost, InterruptedException {
        if (!earnsSpeed(student, marking)) return SpeedTrial.SpeedOutcome.none(tooInaccurate());
        try {
            if (settings.speed() == JudgeSettings.Speed.ONCE)
                return trial(student, student, cases.repeated(), false, marking).once();
            if (model.isEmpty() || beside.isEmpty())
                return SpeedTrial.SpeedOutcome.none(SpeedTrial.UNSETTLED);
            Student reference = beside.get().reference();
            boolean begun = beside.get().areOf(student);
            SpeedTrial trial = trial(student, reference, cases.repeated(), begun, marking);
            SpeedTrial.SpeedOutcome outcome = trial.measure();
            figures = figures(outcome, trial, model.get(), marking);
            return outcome;
        } catch (ChildLost lost) {
            if (lost.isOursToRepeat(again)) throw lost;
            return SpeedTrial.SpeedOutcome.none(
                    lost.isIdle()
                            ? SpeedTrial.UNSETTLED
                            : Message.of(topic.inOwnWords("speed.stopped")).and(lost.message()));
        }
    }

    private SpeedTrial trial(
            Student student,
            Student reference,
            List<GradedCall> before,
            boolean begun,
            Marking marking) {
        return new SpeedTrial(
                contract,
                exercise.caps(),
                topic.timings(exercise, new SecureRandom(), marking.uncharged()),
                topic::inOwnWords,
                student,
                reference,
                before,
                begun,
                marking.charged(),
                settings.patience());
    }

    private Optional<SpeedFigures> figures(
            SpeedTrial.SpeedOutcome speed, SpeedTrial trial, Models.Model model, Marking marking) {
        var run = new FiguresRun(exercise, topic, models);
        return trial.last().flatMap(timing -> run.of(speed, timing, model, marking.cases()));
    }
}
