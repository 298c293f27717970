package rasterlab.exercises.runner;

import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.marking.Marking;
import rasterlab.exercises.runner.scan.ByteCodeCheck;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Report;
import rasterlab.exercises.score.SpeedPoints;
import rasterlab.exercises.topic.TopicGradings;

/** One grading, each try with three children of its own. */
final class GradingRun {
    private final JudgeSettings settings;
    private final ByteCodeCheck check;
    private final Exercise exercise;
    private final TopicGrading topic;
    private final String source;
    private final CaseSelection selection;
    private final Consumer<CaseReport> progress;
    private final ReportSheet sheet;
    private boolean tried;
    private boolean again;

    GradingRun(
            JudgeSettings settings,
            ByteCodeCheck check,
            Exercise exercise,
            String source,
            CaseSelection selection,
            Consumer<CaseReport> progress,
            ReportSheet sheet) {
        this.settings = settings;
        this.check = check;
        this.exercise = exercise;
        this.topic = TopicGradings.named(exercise.topic());
        this.source = source;
        this.selection = selection;
        this.progress = progress;
        this.sheet = sheet;
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
    Report run(Children children) throws ChildLost, InterruptedException {
        again = tried;
        tried = true;
        try (Child compiler = children.take(ChildKind.COMPILE);
                Child runner = children.take(ChildKind.RUN);
                Child reference = children.take(ChildKind.RUN)) {
            Compilation compiled = Compilation.of(source, compiler, settings.compileLimit());
            if (compiled.verdict() != GradingVerdict.OK)
                return sheet.rejected(compiled.verdict(), compiled.errors());
            String contract = topic.contract().getName().replace('.', '/');
            ByteCodeCheck.Result checked = check.check(compiled.classes(), contract, source);
            if (!checked.refusals().isEmpty())
                return sheet.rejected(GradingVerdict.REFUSED, checked.refusals());
            return tried(
                    compiled,
                    checked.entry(),
                    new StudentRun(runner, settings.callLimit(), settings.runLimit()),
                    new StudentRun(reference, settings.callLimit(), settings.runLimit()));
        }
    }

    private Report tried(
            Compilation compiled, String entry, StudentRun student, StudentRun reference)
            throws ChildLost, InterruptedException {
        CaseRun cases = new CaseRun(exercise, topic, selection.seed(), student, again);
        Marking marking = new Marking(exercise);
        Optional<Finding> unloaded = cases.load(entry, compiled.classes());
        for (Case one : selected(exercise, selection)) {
            boolean first = marking.isEmpty();
            progress.accept(
                    marking.add(
                            first && unloaded.isPresent()
                                    ? cases.skip(one, unloaded.get())
                                    : cases.tryOut(one)));
        }
        List<CaseReport> reports = marking.reports();
        SpeedTrial.Outcome speed =
                cases.isStopped() || !aboveFloor(reports)
                        ? SpeedTrial.Outcome.none(tooInaccurate())
                        : speed(student, reference, marking.charged());
        int most = exercise.points().speed();
        CaseReport speedReport =
                speed.obstacle().isEmpty()
                        ? SpeedPoints.measured(
                                speed.nanosPerPixel(), speed.reference(), speed.printed(), most)
                        : SpeedPoints.none(most, speed.obstacle());
        progress.accept(speedReport);
        List<Diagnostic> said = new ArrayList<>();
        Message shared = marking.shared();
        if (!shared.isEmpty()) said.add(new Diagnostic(0, 0, shared));
        said.addAll(cases.printed());
        return sheet.graded(reports, speedReport, said, speed.nanosPerPixel());
    }

    private static Message tooInaccurate() {
        return Message.of("speed.floor", Math.round(100 * SpeedPoints.ACCURACY_FLOOR));
    }

    private boolean aboveFloor(List<CaseReport> reports) {
        List<String> accuracy =
                exercise.cases().stream()
                        .filter(one -> one.kind() == Kind.ACCURACY)
                        .map(Case::name)
                        .toList();
        List<CaseReport> counted =
                reports.stream().filter(one -> accuracy.contains(one.name())).toList();
        int earned = counted.stream().mapToInt(CaseReport::points).sum();
        int possible = counted.stream().mapToInt(CaseReport::of).sum();
        return earned >= SpeedPoints.ACCURACY_FLOOR * possible;
    }

    /** A method that is stopped while it is timed loses the points for speed only. */
    private SpeedTrial.Outcome speed(StudentRun student, StudentRun reference, Set<String> charged)
            throws ChildLost, InterruptedException {
        try {
            return new SpeedTrial(topic, student, reference, charged, new SecureRandom().nextLong())
                    .measure();
        } catch (ChildLost lost) {
            if (lost.isOursToRepeat(again)) throw lost;
            return SpeedTrial.Outcome.none(Message.of("speed.stopped").and(lost.said()));
        }
    }
}
