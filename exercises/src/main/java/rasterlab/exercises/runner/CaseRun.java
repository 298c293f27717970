package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.Call;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/** Tries one loaded method on one case after the other, until it is stopped. */
final class CaseRun {
    private final Exercise exercise;
    private final TopicGrading topic;
    private final long seed;
    private final StudentRun run;
    private final List<Diagnostic> printed = new ArrayList<>();
    private Optional<Finding> stopped = Optional.empty();

    CaseRun(Exercise exercise, TopicGrading topic, long seed, StudentRun run) {
        this.exercise = exercise;
        this.topic = topic;
        this.seed = seed;
        this.run = run;
    }

    /** Whether the method was stopped, so that nothing more can be asked of it. */
    boolean isStopped() {
        return stopped.isPresent();
    }

    /** What was printed in open cases. */
    List<Diagnostic> printed() {
        return printed;
    }

    /** Loads the classes; a failure is told with the first case. */
    Optional<Finding> load(String entry, Map<String, byte[]> classes)
            throws ChildLost, InterruptedException {
        try {
            Answer answer = run.load(entry, classes);
            return answer.ending() == Answer.Ending.THREW
                    ? Optional.of(
                            Finding.of(
                                    GradingVerdict.RUNTIME_ERROR,
                                    Message.of("creating", answer.thrown()).and(answer.place())))
                    : Optional.empty();
        } catch (ChildLost lost) {
            return Optional.of(finding(lost));
        }
    }

    /** The case is not tried for a reason that came before it. */
    CaseReport skip(Case one, Finding reason) {
        stopped = Optional.of(reason);
        return report(one, reason, "");
    }

    /**
     * @throws ChildLost when the child was killed from outside: no fault of the student's
     */
    CaseReport judge(Case one) throws ChildLost, InterruptedException {
        if (stopped.isPresent())
            return report(one, Finding.of(GradingVerdict.NOT_RUN, Message.of("not-run")), "");
        List<Call> calls = topic.calls(one, exercise.tolerance(), seed);
        for (Call call : calls) {
            Finding finding = tried(one, call);
            if (finding.verdict() != GradingVerdict.OK)
                return report(one, finding, call.scene(finding.drawn()));
        }
        return report(one, Finding.OK, calls.get(0).scene());
    }

    private Finding tried(Case one, Call call) throws ChildLost, InterruptedException {
        try {
            Answer answer = run.call(call);
            if (one.visibility() == Disclosure.OPEN && !answer.printed().isBlank())
                printed.add(
                        new Diagnostic(
                                0,
                                0,
                                Message.of(
                                        "printed.case",
                                        one.title("en"),
                                        one.title("ru"),
                                        answer.printed().stripTrailing())));
            Finding finding = call.judge(answer);
            if (run.over()) stopped = Optional.of(finding);
            return finding;
        } catch (ChildLost lost) {
            stopped = Optional.of(finding(lost));
            return stopped.get();
        }
    }

    private static Finding finding(ChildLost lost) throws ChildLost {
        GradingVerdict verdict =
                switch (lost.reason()) {
                    case TIME -> GradingVerdict.TIME_LIMIT;
                    case MEMORY -> GradingVerdict.MEMORY_LIMIT;
                    case OUTPUT -> GradingVerdict.OUTPUT_LIMIT;
                    case ENDED, PROTOCOL -> GradingVerdict.NO_RESULT;
                    case KILLED -> throw lost;
                };
        return Finding.of(verdict, lost.said());
    }

    private static CaseReport report(Case one, Finding finding, String scene) {
        return new CaseReport(
                one.name(),
                one.visibility(),
                finding.verdict(),
                finding.verdict() == GradingVerdict.OK ? one.points() : 0,
                one.points(),
                finding.said(),
                finding.pictures(),
                scene);
    }
}
