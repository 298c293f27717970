package rasterlab.exercises.runner;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.Call;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.marking.TriedCase;
import rasterlab.exercises.score.Answer;
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
    private final boolean again;
    private final List<Diagnostic> printed = new ArrayList<>();
    private Optional<Finding> stopped = Optional.empty();

    /**
     * @param again whether this was tried before: then a signal is no accident but what the method
     *     makes of its process
     */
    CaseRun(Exercise exercise, TopicGrading topic, long seed, StudentRun run, boolean again) {
        this.again = again;
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
    TriedCase skip(Case one, Finding reason) {
        stopped = Optional.of(reason);
        return TriedCase.untried(one, reason);
    }

    /**
     * @throws ChildLost when the child was killed from outside: no fault of the student's
     */
    TriedCase tryOut(Case one) throws ChildLost, InterruptedException {
        if (stopped.isPresent())
            return TriedCase.untried(
                    one, Finding.of(GradingVerdict.NOT_RUN, Message.of("not-run")));
        List<TriedCall> tried = new ArrayList<>();
        for (Call call : topic.calls(one, exercise.tolerance(), seed)) {
            tried.add(tried(one, call));
            if (stopped.isPresent()) break;
        }
        return TriedCase.tried(one, tried);
    }

    private TriedCall tried(Case one, Call call) throws ChildLost, InterruptedException {
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
            TriedCall tried = TriedCall.answered(call, answer);
            if (run.over()) stopped = Optional.of(tried.finding());
            return tried;
        } catch (ChildLost lost) {
            stopped = Optional.of(finding(lost));
            return TriedCall.failed(call, stopped.get());
        }
    }

    private Finding finding(ChildLost lost) throws ChildLost {
        if (lost.isOursToRepeat(again)) throw lost;
        GradingVerdict verdict =
                switch (lost.reason()) {
                    case TIME -> GradingVerdict.TIME_LIMIT;
                    case MEMORY -> GradingVerdict.MEMORY_LIMIT;
                    case OUTPUT -> GradingVerdict.OUTPUT_LIMIT;
                    case ENDED, PROTOCOL, SIGNAL, KILLED -> GradingVerdict.NO_RESULT;
                };
        return Finding.of(verdict, lost.said());
    }
}
